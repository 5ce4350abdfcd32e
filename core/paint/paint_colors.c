#include "paint_colors.h"

#include "../format/word.h"

/* Colors between a paint and a format, a power of two: a paint starts anew for
 * every part, but there is little stack where code is to be small. */
enum {
    RUN_PIXELS = PEL_64BIT        ? 64
                 : PEL_SMALL_CODE ? 4
                                  : PEL_AT_A_TIME(16, 8)
};

/* The runs go through a short buffer in parts that begin at multiples of its
 * length; or the surface is the buffer. Little is kept over the calls, to spare
 * stack. */
void pel_color_paint_fill(const struct pel_paint *paint,
                          const struct pel_spans *spans)
{
    const struct pel_color_paint *p = (const void *)paint;
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    pel_color colors[RUN_PIXELS];
    for (; span < spans->span + spans->n; span++, y += spans->step) {
        int32_t x = span->x0, n = span->x1 - x;
        if (n > 0 && pel_colors_in_place(p, spans->surface)) {
            p->colors(p, x, y, n, pel_address32(spans->surface, x, y));
            continue;
        }
        for (; x < span->x1; x += n) {
            n = pel_min(span->x1 - x, RUN_PIXELS - (x & (RUN_PIXELS - 1)));
            p->colors(p, x, y, n, colors);
            pel_put_colors(spans->surface, x, y, n, colors);
        }
    }
}
