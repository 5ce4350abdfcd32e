/* E-paper controllers as their data sheets have them, behind a bus that may
 * fail, and what their glass shows; written independently of drivers/. */
#ifndef TESTS_SUPPORT_PAPER_GLASS_H
#define TESTS_SUPPORT_PAPER_GLASS_H

#include "drivers/bus.h"

enum paper_family { PAPER_SSD, PAPER_UC8151, PAPER_UC8179 };
enum paper_ink {
    PAPER_WHITE,
    PAPER_BLACK,
    PAPER_COLOR,
    PAPER_GRAY /* and 0 to 3 */
};
enum { PAPER_BYTES = 800 / 8 * 480, PAPER_LIST = 64 };

struct paper_glass {
    struct pel_bus bus;

    /* Set by the test. */
    enum paper_family family;
    int width, height;
    bool color, gray;
    bool dma;    /* rows leave when the next call comes */
    bool stuck;  /* busy for ever */
    int fail_at; /* the call that fails, from 1; 0: none */

    /* For the test to read. */
    int calls, refreshes;
    uint32_t ms;
    uint8_t shown[PAPER_BYTES * 8]; /* enum paper_ink */
    uint8_t white;                  /* of them */

    /* State. */
    struct pel_bus_rows flight;
    uint8_t plane[2][PAPER_BYTES]; /* 24h and 26h, or 13h and 10h */
    uint8_t parameter[PAPER_LIST];
    int command, n; /* parameters, or bytes of a plane */
    int busy;       /* polls that it stays so */
    int row_bytes;  /* of an SSD's window */
    int x, y;
    int mode;                 /* 22h, or E5h */
    int warmth;               /* 1Ah */
    uint8_t registers[5][44]; /* 20h to 24h of a UC8151 */
    bool grays;    /* the waveform that was chosen is that of four greys */
    bool waveform; /* 32h, or PSR's REG */
    bool asleep, powered, ready;
};

/* The rest of the struct is as the test has set it. */
void paper_glass_init(struct paper_glass *glass);

/* The level of the pin. */
bool paper_glass_busy(struct paper_glass *glass);

#endif
