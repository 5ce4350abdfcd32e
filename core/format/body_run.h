/* The body of formats whose pixels lie side by side: a place points to one, and
 * `at` finds it. */
#ifndef PEL_FORMAT_BODY_RUN_H
#define PEL_FORMAT_BODY_RUN_H

#include "body.h"

static inline void blend(const struct pel_spans *spans, pel_color color)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int32_t i = spans->n; i > 0; i--, span++, y += spans->step) {
        place p = at(spans->surface, span->x0, y);
        for (int32_t n = span->x1 - span->x0; n > 0; n--)
            over(p++, color);
    }
}

static void put(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                const pel_color *colors)
{
    for (place p = at(s, x, y); n > 0; n--)
        over(p++, *colors++);
}

static void load(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                 pel_color *colors)
{
    for (place p = at(s, x, y); n > 0; n--)
        *colors++ = unpack(get(p++));
}

#endif
