/* A display whose transfers take a random time, as a DMA's do: flush returns at
 * once, the pixels reach the screen later. Pixels in flight are poisoned in the
 * program's memory until they have arrived, so that a program which reads or
 * writes them meanwhile is found: what it reads is wrong, what it writes is
 * counted. Time passes in steps, in wait, in a flush that has to wait, and
 * where the test says so; so every run can be repeated. */
#ifndef TESTS_SUPPORT_DISPLAY_DMA_H
#define TESTS_SUPPORT_DISPLAY_DMA_H

#include "cases.h"
#include "drivers/display.h"

enum { DISPLAY_DMA_BYTES = 16384 };

struct display_dma {
    /* Set by the test, the rest zero. */
    struct pel_surface screen; /* what the panel shows; not of pages */
    struct random random;
    int32_t most_steps; /* a transfer takes 1 to this */
    int32_t window;     /* corners of areas are multiples of it, or 0 */
    bool broken;        /* transfers never end; waiting gives an error */

    /* For the test to read. */
    int32_t steps_left; /* of the transfer in flight; 0: idle */
    int32_t transfers;  /* begun */
    uint32_t bytes;     /* of them */
    int32_t flips;
    int32_t touched; /* lines in flight that the program wrote to */

    struct pel_surface source;       /* in flight */
    uint8_t held[DISPLAY_DMA_BYTES]; /* its pixels */
};

/* `dma` is the context, and stays the test's. */
void display_dma_init(struct pel_display *display, struct display_dma *dma);

/* Time passes: a transfer may end, as an interrupt would tell. */
void display_dma_step(struct display_dma *dma);

#endif
