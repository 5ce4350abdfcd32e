#include "paint_phong.h"

/* What moves along a run: three parts of the normal, three of the place. */
struct walk {
    uint64_t at[6];
    uint32_t color[3]; /* blue first */
};

static void start(const struct pel_phong *p, int32_t x, int32_t y,
                  struct walk *w)
{
    for (int k = 0; k < 6; k++)
        w->at[k] = pel_plane_at(k < 3 ? &p->normal[k] : &p->place[k - 3], x, y);
    for (int k = 0; k < 3; k++)
        w->color[k] = p->colors.at[k] + (uint32_t)x * p->colors.dx[k] +
                      (uint32_t)y * p->colors.dy[k];
}

static void step(const struct pel_phong *p, struct walk *w)
{
    for (int k = 0; k < 6; k++)
        w->at[k] += k < 3 ? p->normal[k].dx : p->place[k - 3].dx;
    for (int k = 0; k < 3; k++)
        w->color[k] += p->colors.dx[k];
}

/* A channel of struct pel_gouraud in 1/256 steps: it has a half more, so that
 * its upper 8 bits are rounded. */
static uint32_t channel(uint32_t v)
{
    return v < 0x800000u ? 0 : (v - 0x7F8000u) >> 16;
}

static pel_color lit(const struct pel_phong *p, const struct walk *w,
                     pel_color under)
{
    struct pel_shine shine;
    int32_t normal[3], place[3];
    for (int k = 0; k < 3; k++) {
        normal[k] = pel_plane_whole(w->at[k]);
        place[k] = pel_plane_whole(w->at[k + 3]);
    }
    pel_mesh_lights_shine(p->lights, place, normal, &shine);
    pel_color out = pel_round_div255(pel_alpha(under) * p->alpha) << 24;
    for (int k = 0; k < 3; k++) {
        const uint32_t surface = p->surface ? (under >> (16 - 8 * k) & 255) << 8
                                            : channel(w->color[2 - k]);
        out |= pel_shine_channel(&shine, k, surface) << (16 - 8 * k);
    }
    return out;
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_phong *p = (const void *)paint;
    struct walk w;
    if (p->surface)
        p->surface->colors(p->surface, x, y, n, out);
    start(p, x, y, &w);
    for (; n > 0; n--, out++) {
        *out = lit(p, &w, p->surface ? *out : UINT32_C(0xFF000000));
        step(p, &w);
    }
}

void pel_phong_init(struct pel_phong *paint, bool opaque)
{
    pel_color_paint_init(&paint->base, colors, opaque);
}
