/* The rows that a paint's `fast` function is given, taken one by one. */
#ifndef TESTS_SUPPORT_FAST_ROWS_H
#define TESTS_SUPPORT_FAST_ROWS_H

#include "core/fast/fast_triangle.h"

#if PEL_FAST_FILLS

typedef void fast_row(void *context, int32_t y, int32_t x0, int32_t x1);

static inline void fast_rows(const struct pel_fast_triangle *t, fast_row *take,
                             void *context)
{
    struct pel_slope a = t->whole, b = t->upper;
    for (int32_t y = t->y0; y < t->y2; y++) {
        if (y == t->y1)
            b = t->lower;
        int32_t p = (int32_t)(a.x >> 32), q = (int32_t)(b.x >> 32);
        take(context, y, pel_min(p, q), pel_max(p, q));
        a.x += a.step;
        b.x += b.step;
    }
}

#endif
#endif
