#include "shaded.h"

void pel_modulated_colors(const struct pel_color_paint *paint, int32_t x,
                          int32_t y, int32_t n, pel_color *out)
{
    const struct pel_shaded *p = (const void *)paint;
    const struct pel_gouraud *g = &p->of.colors;
    uint32_t v[4];
    p->surface->colors(p->surface, x, y, n, out);
    for (int k = 0; k < 4; k++)
        v[k] = g->at[k] + (uint32_t)x * g->dx[k] + (uint32_t)y * g->dy[k];
    for (; n > 0; n--, out++) {
        pel_color color = 0;
        for (int k = 0; k < 4; k++) {
            color |= pel_round_div255((*out >> 8 * k & 255) * (v[k] >> 24))
                     << 8 * k;
            v[k] += g->dx[k];
        }
        *out = color;
    }
}
