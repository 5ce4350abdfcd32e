#include "paint_colors.h"

#include "../format/word.h"

/* Colors between a paint and a format, powers of two: a paint starts anew for
 * every part, but there is little stack where code is to be small. */
enum {
    RUN_PIXELS = PEL_64BIT        ? 64
                 : PEL_SMALL_CODE ? 4
                                  : PEL_AT_A_TIME(16, 8),
    ROW_PIXELS = PEL_AT_A_TIME(RUN_PIXELS, 4) /* of rows that come alone */
};

/* Where the surface is the buffer. */
static PEL_STEP_OR_INLINE void fill_in_place(const struct pel_color_paint *p,
                                             const struct pel_spans *spans)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (; span < spans->span + spans->n; span++, y += spans->step)
        if (span->x0 < span->x1)
            p->colors(p, span->x0, y, span->x1 - span->x0,
                      pel_address32(spans->surface, span->x0, y));
}

/* y, or the same anew: where code is to be small it is not kept over calls. */
static inline int32_t row_of(const struct pel_spans *spans,
                             const struct pel_span *span, int32_t y)
{
    return PEL_SMALL_CODE
               ? spans->y + (int32_t)(span - spans->span) * spans->step
               : y;
}

/* Through a short buffer, in parts that begin at multiples of its length, but
 * where stack is short. Little is kept over the calls, to spare stack. */
static PEL_STEP_OR_INLINE void fill_rows(const struct pel_color_paint *p,
                                         const struct pel_spans *spans)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    pel_color colors[RUN_PIXELS];
    for (; span < spans->span + spans->n; span++, y += spans->step)
        for (int32_t x = span->x0, n; x < span->x1; x += n) {
            const int32_t before = PEL_SHORT_STACK ? 0 : x & (RUN_PIXELS - 1);
            n = pel_min(span->x1 - x, RUN_PIXELS - before);
            p->colors(p, x, row_of(spans, span, y), n, colors);
            pel_put_colors(spans->surface, x, row_of(spans, span, y), n,
                           colors);
        }
}

static PEL_STEP_OR_INLINE void fill_row(const struct pel_color_paint *p,
                                        const struct pel_spans *row)
{
    pel_color colors[ROW_PIXELS];
    for (int32_t x = row->span->x0, n; x < row->span->x1; x += n) {
        n = pel_min(row->span->x1 - x, ROW_PIXELS);
        p->colors(p, x, row->y, n, colors);
        pel_put_colors(row->surface, x, row->y, n, colors);
    }
}

void pel_color_paint_fill(const struct pel_paint *paint,
                          const struct pel_spans *spans)
{
    const struct pel_color_paint *p = (const void *)paint;
    if (pel_colors_in_place(p, spans->surface))
        fill_in_place(p, spans);
    else if (PEL_SHORT_STACK && spans->n == 1)
        fill_row(p, spans);
    else
        fill_rows(p, spans);
}
