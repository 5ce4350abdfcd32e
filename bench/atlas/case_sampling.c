/* Texels between texels, against exact bilinear ones, by the contrast of
 * neighbours: the nearest, and bilinear with weights of a few bits. */
#include <math.h>
#include <stdio.h>

#include <pel/pel.h>

#include "cases.h"

enum { SIDE = 16, LENGTH = 256 };

static int texel[SIDE][SIDE];

/* 2^-16 texels. */
struct spot {
    int u, v;
};

/* The four texels around (u, v) - 1/2, mixed by weights of so many bits. */
static double bilinear(struct spot at, int bits)
{
    const int u = at.u - 32768, v = at.v - 32768, unit = 1 << (16 - bits);
    const double one = 1 << bits;
    const double fu = ((u & 65535) + unit / 2) / unit / one;
    const double fv = ((v & 65535) + unit / 2) / unit / one;
    const int i = u >> 16, k = v >> 16;
    return (1 - fv) * ((1 - fu) * texel[k][i] + fu * texel[k][i + 1]) +
           fv * ((1 - fu) * texel[k + 1][i] + fu * texel[k + 1][i + 1]);
}

static double nearest(struct spot at)
{
    return texel[at.v >> 16][at.u >> 16];
}

/* Neighbours that differ by at most `contrast`, often by as much. */
static void make_texels(struct random *r, int contrast)
{
    for (int i = 0; i < SIDE * SIDE; i++)
        texel[i / SIDE][i % SIDE] = random_between(r, 0, 1)
                                        ? contrast * random_between(r, 0, 1)
                                        : random_between(r, 0, contrast);
}

enum { NEAREST, BITS_MOST = 8, PEL_NEAREST, PEL_BILINEAR, METHODS };

/* Pel's colors along a line through the texture. */
static void colors_of(bool is_nearest, struct spot from, struct spot step,
                      pel_color out[LENGTH])
{
    static pel_color color[SIDE * SIDE];
    const struct pel_texels texels = {
        .colors = color, .width = SIDE, .height = SIDE};
    const struct pel_texture_map map = {
        {(uint64_t)from.u << 16, (uint64_t)(int64_t)step.u << 16, 0},
        {(uint64_t)from.v << 16, (uint64_t)(int64_t)step.v << 16, 0}};
    struct pel_texture paint;
    for (int i = 0; i < SIDE * SIDE; i++)
        color[i] = PEL_RGB(0, 0, texel[i / SIDE][i % SIDE]);
    if ((is_nearest ? pel_texture_init_nearest
                    : pel_texture_init_bilinear)(&paint, &texels, &map))
        method_fail("a texture is refused", "take legal texels");
    paint.base.colors(&paint.base, 0, 0, LENGTH, out);
}

static void measure(struct random *r, double worst[METHODS])
{
    const int low = 65536, high = (SIDE - 1) * 65536;
    const struct spot from = {random_between(r, low, high),
                              random_between(r, low, high)};
    const struct spot step = {(random_between(r, low, high) - from.u) / LENGTH,
                              (random_between(r, low, high) - from.v) / LENGTH};
    pel_color pel[2][LENGTH];
    colors_of(true, from, step, pel[0]);
    colors_of(false, from, step, pel[1]);
    for (int x = 0; x < LENGTH; x++) {
        const struct spot at = {from.u + x * step.u, from.v + x * step.v};
        const double exact = bilinear(at, 16);
        double shown[METHODS] = {nearest(at)};
        for (int bits = 1; bits <= BITS_MOST; bits++)
            shown[bits] = floor(bilinear(at, bits) + .5);
        shown[PEL_NEAREST] = pel[0][x] & 255;
        shown[PEL_BILINEAR] = pel[1][x] & 255;
        for (int m = 0; m < METHODS; m++)
            worst[m] = fmax(worst[m], fabs(shown[m] - exact));
    }
}

/* (Du + Dv) / 2, and D 2^(1 - B) + 1/2; paint_texture.h. */
static double bound_of(int method, double contrast)
{
    if (method == NEAREST || method == PEL_NEAREST)
        return contrast;
    const int bits = method == PEL_BILINEAR ? 9 : method;
    return contrast * 2 / (1 << bits) + .5;
}

void atlas_sampling(struct atlas *a)
{
    for (int contrast = 1; contrast < 256; contrast = 2 * contrast + 1) {
        struct random r = atlas_random(a, (uint32_t)contrast);
        double worst[METHODS] = {0};
        for (int n = atlas_samples(a, 4000, 200); n > 0; n--) {
            make_texels(&r, contrast);
            measure(&r, worst);
        }
        for (int m = 0; m < METHODS; m++) {
            char name[32] = "nearest";
            if (m == PEL_NEAREST || m == PEL_BILINEAR)
                snprintf(name, sizeof name, "pel %s",
                         m == PEL_NEAREST ? "nearest" : "bilinear");
            else if (m)
                snprintf(name, sizeof name, "bilinear %d bits", m);
            atlas_put_bound(
                a, figure_of(name, contrast, "error_max", worst[m], "step"),
                bound_of(m, contrast));
        }
    }
}
