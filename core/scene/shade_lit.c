#include "shaded.h"

/* Not inlined: its stack is free while the surface computes its colors. */
static PEL_NOINLINE void light(const struct pel_shaded *paint, int32_t x,
                               int32_t y, int32_t n, pel_color *out)
{
    struct pel_shaded_row row;
    pel_shaded_start(&row, paint, x, x, y);
    for (; n > 0; n--, out++) {
        struct pel_light_sum sum;
        pel_shaded_light(&row, paint, 0, &sum);
        *out = pel_shaded_color(&row, paint, &sum, *out);
    }
}

void pel_lit_colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                    int32_t n, pel_color *out)
{
    const struct pel_shaded *p = (const void *)paint;
    pel_shaded_surface(p, x, y, n, out);
    light(p, x, y, n, out);
}
