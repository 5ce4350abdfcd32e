/* A bus that notes what is sent, as a logic analyser would. With `dma` the rows
 * of `data` leave later: in `wait`, or when the next call has to wait; until
 * then what they lie in is poison, when that is `pixels`, and is read as late
 * as that where it is not. */
#ifndef TESTS_SUPPORT_BUS_LOG_H
#define TESTS_SUPPORT_BUS_LOG_H

#include "drivers/bus.h"

enum { BUS_LOG_DATA = 0x100, BUS_LOG_RESET = 0x200, BUS_LOG_SIZE = 500000 };

struct bus_log {
    struct pel_bus bus;

    /* Set by the test. */
    bool dma;
    uint8_t *pixels; /* memory that may be poisoned */
    size_t size;
    int fail_at; /* the call that fails, from 1; 0: none */

    /* For the test to read. */
    int calls;
    uint32_t ms; /* of pauses */
    int count;
    uint16_t log[BUS_LOG_SIZE]; /* bytes, with BUS_LOG_DATA where D/C is high */

    struct pel_bus_rows flight; /* length 0: nothing */
    uint8_t held[BUS_LOG_SIZE];
};

/* The rest of the struct is zero, or as the test has set it. */
void bus_log_init(struct bus_log *log);

#endif
