/* A bus to a chip beside the processor, a panel or a touch controller: SPI with
 * a data/command line, I2C, or parallel (bus_8080.h). The one thing that a
 * platform brings; port/linux has it for spidev and i2c-dev, docs/firmware.md
 * shows one for a microcontroller with DMA.
 *
 * Four functions, of which only `command` is always there. A bus is one chip's:
 * its chip select or its address belongs to the context. Calls come from one
 * thread at a time. Errors are PEL_ERROR_DEVICE; what went wrong, the bus tells
 * in a way of its own.
 *
 * One transfer at a time is in flight. `data` may return while a DMA still
 * reads the pixels; `command`, `data` and `pause` wait by themselves for what
 * is in flight, and tell its error. */
#ifndef PEL_DRIVERS_BUS_H
#define PEL_DRIVERS_BUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <pel/pel.h>

/* Rows of bytes, as of a window in a larger picture. */
struct pel_bus_rows {
    const uint8_t *bytes; /* the first row */
    int32_t length;       /* bytes of a row, 1 or more */
    int32_t count;        /* rows, 1 or more; 1 where they follow each other */
    int32_t stride;       /* bytes from a row to the next */
};

struct pel_bus {
    void *context;

    /* Sends n >= 1 bytes with D/C low (on I2C to a display: with control byte
     * 0x00), then reads `answers` bytes, all in one chip select. Over when it
     * returns: the bytes are the caller's. A chip that never answers is an
     * error after a time of the bus's choice. */
    enum pel_status (*command)(const struct pel_bus *bus, const uint8_t *bytes,
                               size_t n, uint8_t *answer, size_t answers);

    /* Sends rows with D/C high (control byte 0x40), in order. The struct is
     * read at once; the bytes may be in flight until `wait` returns. NULL for
     * chips that take commands alone, as touch controllers do. */
    enum pel_status (*data)(const struct pel_bus *bus,
                            const struct pel_bus_rows *rows);

    /* With `reset` gives the chip a pulse on its reset line, of 10 us or more;
     * then returns after `ms` milliseconds at least. A bus without a reset line
     * only takes the time. */
    enum pel_status (*pause)(const struct pel_bus *bus, bool reset,
                             uint32_t ms);

    /* Nothing is in flight any more: looks at what the interrupt noted when
     * the last byte had left, and gives up after a time of the bus's choice.
     * NULL: `data` is over when it returns. */
    enum pel_status (*wait)(const struct pel_bus *bus);
};

#endif
