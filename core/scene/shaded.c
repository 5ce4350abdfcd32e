#include "shaded.h"

/* One walk serves all functions where code is to be short. */
#if defined(__OPTIMIZE_SIZE__) || PEL_SMALL_CODE
enum { SHORT = 1 };
#else
enum { SHORT = 0 };
#endif

pel_color pel_lit_pixel(const struct pel_shaded *paint,
                        int32_t value[PEL_VALUES], pel_color under)
{
    if (paint->end == PEL_AT_COLOR)
        pel_color_values(under, value);
    return pel_lit_color(paint->lights, value);
}

pel_color pel_modulated_pixel(const struct pel_shaded *paint,
                              int32_t value[PEL_VALUES], pel_color under)
{
    pel_color color = 0;
    (void)paint;
    PEL_UNROLL
    for (int k = 0; k < 3; k++) {
        const uint32_t part = (uint32_t)value[PEL_AT_COLOR + k] + 0x8000u;
        color |= pel_round_div255((under >> 8 * k & 255) * (part >> 16))
                 << 8 * k;
    }
    return color;
}

/* Sets values to those at a pixel, light's in whole units; their planes go on
 * to the next one. */
static PEL_HOT void step(const struct pel_shaded *p, uint64_t at[PEL_VALUES],
                         int32_t value[PEL_VALUES], int first, int end)
{
    PEL_UNROLL
    for (int k = first; k < end; k++) {
        value[k] = (int32_t)(at[k] >> (k < PEL_AT_COLOR ? 24 : 8));
        at[k] += p->plane[k].dx;
    }
}

/* Three by three where code may be long. */
static PEL_ALWAYS_INLINE void walk(const struct pel_shaded *p,
                                   struct pel_point from, int32_t n,
                                   pel_color *out, pel_pixel_function *pixel)
{
    const bool modulates = pixel == pel_modulated_pixel;
    uint64_t at[PEL_VALUES];
    int32_t value[PEL_VALUES];
    for (int k = p->first; k < p->end; k++)
        at[k] = pel_plane_at(&p->plane[k], from.x, from.y);
    for (; n > 0; n--, out++) {
        const uint32_t alpha = pel_round_div255(pel_alpha(*out) * p->alpha);
        if (SHORT) {
            step(p, at, value, p->first, p->end);
        } else if (!modulates) {
            step(p, at, value, PEL_AT_NORMAL, PEL_AT_POSITION);
            step(p, at, value, PEL_AT_POSITION, PEL_AT_COLOR);
        }
        if (!SHORT && (modulates || p->end == PEL_VALUES))
            step(p, at, value, PEL_AT_COLOR, PEL_VALUES);
        *out = pixel(p, value, *out) | alpha << 24;
    }
}

/* Not inlined: its stack is free while the surface computes its colors. */
static PEL_NOINLINE void shade(const struct pel_shaded *p, int32_t x, int32_t y,
                               int32_t n, pel_color *out)
{
    const struct pel_point from = {x, y};
    if (!SHORT && p->pixel == pel_modulated_pixel)
        walk(p, from, n, out, pel_modulated_pixel); /* inlined */
    else
        walk(p, from, n, out, p->pixel);
}

void pel_shaded_colors(const struct pel_color_paint *paint, int32_t x,
                       int32_t y, int32_t n, pel_color *out)
{
    const struct pel_shaded *p = (const void *)paint;
    if (p->surface)
        p->surface->colors(p->surface, x, y, n, out);
    else
        for (int32_t i = 0; i < n; i++)
            out[i] = p->under;
    shade(p, x, y, n, out);
}
