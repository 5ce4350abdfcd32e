#include "shaded.h"

/* v / 2^bits, cut towards 0: light stays between that of the two ends. */
static inline int32_t part_of(int32_t v, int bits)
{
    return v < 0 ? -(-v >> bits) : v >> bits;
}

/* The change a pixel between the ends of a span, and what `from` has become
 * after n pixels. */
static inline void set_line(struct pel_light_sum *from,
                            const struct pel_light_sum *to, int bits, int32_t n,
                            struct pel_light_sum *step)
{
    PEL_UNROLL
    for (int k = 0; k < 3; k++) {
        step->surface[k] = part_of(to->surface[k] - from->surface[k], bits);
        step->plain[k] = part_of(to->plain[k] - from->plain[k], bits);
        from->surface[k] += n * step->surface[k];
        from->plain[k] += n * step->plain[k];
    }
}

static inline void go_on(struct pel_light_sum *sum,
                         const struct pel_light_sum *step)
{
    PEL_UNROLL
    for (int k = 0; k < 3; k++) {
        sum->surface[k] += step->surface[k];
        sum->plain[k] += step->plain[k];
    }
}

/* Not inlined: its stack is free while the surface computes its colors. */
static PEL_NOINLINE void light(const struct pel_shaded *p, int32_t x, int32_t y,
                               int32_t n, pel_color *out)
{
    const int32_t span = (int32_t)(UINT32_C(1) << p->span);
    const pel_color *end = out + n;
    struct pel_light_sum from, to, step;
    struct pel_shaded_row row;
    int32_t begin = x & -span; /* of the span that x is in */
    pel_shaded_start(&row, p, x, begin, y);
    pel_shaded_light(&row, p, p->span, &to);
    while (out < end) {
        from = to;
        pel_shaded_light(&row, p, p->span, &to);
        set_line(&from, &to, p->span, x - begin, &step);
        begin += span;
        for (; x < begin && out < end; x++, out++) {
            *out = pel_shaded_color(&row, p, &from, *out);
            go_on(&from, &step);
        }
    }
}

void pel_spans_colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                      int32_t n, pel_color *out)
{
    const struct pel_shaded *p = (const void *)paint;
    pel_shaded_surface(p, x, y, n, out);
    light(p, x, y, n, out);
}
