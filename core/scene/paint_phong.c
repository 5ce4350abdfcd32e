#include "paint_phong.h"

/* A channel of struct pel_gouraud in 1/256 steps: it has a half more, so that
 * its upper 8 bits are rounded. */
static uint32_t channel(uint32_t v)
{
    return v < 0x800000u ? 0 : (v - 0x7F8000u) >> 16;
}

static pel_color lit(const struct pel_phong *p, int32_t x, int32_t y,
                     pel_color under)
{
    const struct pel_gouraud *g = &p->colors;
    struct pel_shine shine;
    int32_t normal[3], place[3];
    for (int k = 0; k < 3; k++) {
        normal[k] = pel_plane_whole(pel_plane_at(&p->normal[k], x, y));
        place[k] = pel_plane_whole(pel_plane_at(&p->place[k], x, y));
    }
    pel_mesh_lights_shine(p->lights, place, normal, &shine);
    pel_color out = pel_round_div255(pel_alpha(under) * p->alpha) << 24;
    for (int k = 0; k < 3; k++) {
        const int at = 16 - 8 * k;
        uint32_t surface = (under >> at & 255) << 8;
        if (!p->surface)
            surface = channel(g->at[2 - k] + (uint32_t)x * g->dx[2 - k] +
                              (uint32_t)y * g->dy[2 - k]);
        out |= pel_shine_channel(&shine, k, surface) << at;
    }
    return out;
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_phong *p = (const void *)paint;
    if (p->surface)
        p->surface->colors(p->surface, x, y, n, out);
    for (; n > 0; n--, x++, out++)
        *out = lit(p, x, y, p->surface ? *out : UINT32_C(0xFF000000));
}

void pel_phong_init(struct pel_phong *paint, bool opaque)
{
    pel_color_paint_init(&paint->base, colors, opaque);
}
