/* A paint that keeps a picture of 8 x 8 pixels around zero as a number of 64
 * bits, for tests that draw all shapes of a lattice. */
#ifndef TESTS_SUPPORT_BIT_PICTURE_H
#define TESTS_SUPPORT_BIT_PICTURE_H

#include "core/pel.h"

enum { BIT_REACH = 4 }; /* px from zero each way */

struct bit_picture {
    struct pel_paint paint;
    uint64_t bits;
    bool twice; /* some pixel was */
};

/* Pixel (x, y) is bit 8 (y + 4) + x + 4. */
static inline uint64_t bit_of(int32_t x, int32_t y)
{
    return UINT64_C(1) << (8 * (y + BIT_REACH) + x + BIT_REACH);
}

static inline void bit_picture_row(void *picture, int32_t y, int32_t x0,
                                   int32_t x1)
{
    struct bit_picture *p = picture;
    for (int32_t x = x0; x < x1; x++) {
        p->twice |= (p->bits & bit_of(x, y)) != 0;
        p->bits |= bit_of(x, y);
    }
}

static inline void bit_picture_fill(const struct pel_paint *paint,
                                    const struct pel_spans *rows)
{
    for (int i = 0; i < rows->n; i++)
        bit_picture_row((void *)(uintptr_t)paint, rows->y + i * rows->step,
                        rows->span[i].x0, rows->span[i].x1);
}

#endif
