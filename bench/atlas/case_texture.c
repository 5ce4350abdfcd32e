/* Texel errors of textures in perspective: a row of 400 px that takes 400
 * texels, its right end r times as far as its left one. */
#include <math.h>
#include <stdio.h>

#include <pel/pel.h>

#include "../methods/perspective.h"
#include "cases.h"

enum { LENGTH = 400, TEXELS = 1024, FIRST = 300 };

/* Distances are whole numbers for Pel: so many units are 1. */
enum { Z_UNIT = 1 << 20, UV_UNIT = 65536 };

/* u begins at any fraction of a texel. */
static struct lane any_lane(struct random *r, double ratio)
{
    const double u =
        FIRST + random_between(r, 0, UV_UNIT - 1) / (double)UV_UNIT;
    const struct lane l = {
        LENGTH, {u, u + LENGTH}, {Z_UNIT, floor(Z_UNIT * ratio)}};
    return l;
}

/* Of the lanes out of their bound, or else of all, the one with the largest
 * error. */
struct worst {
    double error, bound;
    bool is_out;
};

/* Span 0 is affine, 1 a division at every pixel. */
static double by_span(const struct lane *l, double x, int span)
{
    return span == 0   ? lane_affine(l, x)
           : span == 1 ? lane_float(l, x)
                       : lane_span(l, x, span);
}

/* The largest bound of the spans that the row touches; those of Pel go on
 * beyond its end. */
static double bound_of(const struct lane *l, int span, bool is_pel)
{
    double most = 0;
    if (span == 0)
        return lane_bound(l, 0, LENGTH);
    for (int x = 0; span > 1 && x < LENGTH; x += span)
        most = fmax(most, lane_bound(l, x + .5,
                                     is_pel ? x + .5 + span
                                            : fmin(x + .5 + span, LENGTH)));
    return most;
}

static double error_of(const struct lane *l, int span)
{
    double worst = 0;
    for (int x = 0; x < LENGTH; x++)
        worst =
            fmax(worst, fabs(by_span(l, x + .5, span) - lane_exact(l, x + .5)));
    return worst;
}

static const struct pel_point corner[3] = {PEL_AT(0, -40), PEL_AT(LENGTH, -40),
                                           PEL_AT(0, 40)};

static void colors_affine(const struct lane *l, struct pel_texture *texture,
                          pel_color *out)
{
    const int32_t u0 = (int32_t)lround(l->u[0] * 256);
    const int32_t u1 = (int32_t)lround(l->u[1] * 256);
    const struct pel_texel_point t[3] = {{u0, 128}, {u1, 128}, {u0, 128}};
    if (pel_texture_map_triangle(&texture->map, corner, t))
        method_fail("a texture's map is refused", "take legal points");
    texture->base.colors(&texture->base, 0, 0, LENGTH, out);
}

static void colors_divided(const struct lane *l, struct pel_texture *texture,
                           int span, pel_color *out)
{
    struct pel_divided_texture p;
    struct pel_plane_setup setup;
    struct pel_texture_corner c[3];
    for (int i = 0; i < 3; i++) {
        const int end = i == 1;
        c[i].uv[0] = llround(l->u[end] * UV_UNIT);
        c[i].uv[1] = UV_UNIT / 2;
        c[i].z = (int32_t)l->z[end];
    }
    pel_plane_start(&setup, corner);
    pel_divided_texture_init(&p, texture, &setup, c, span);
    p.by.base.colors(&p.by.base, 0, 0, LENGTH, out);
}

/* How far the exact coordinate lies from the texel that Pel takes, whose number
 * is its color. */
static double error_of_pel(const struct lane *l, int span)
{
    static pel_color texel[TEXELS];
    const struct pel_texels texels = {
        .colors = texel, .width = TEXELS, .height = 1};
    struct pel_texture texture;
    struct pel_texture_map map = PEL_TEXTURE_AT(0, 0);
    pel_color out[LENGTH];
    double worst = 0;
    for (pel_color i = 0; i < TEXELS; i++)
        texel[i] = i;
    if (pel_texture_init_nearest(&texture, &texels, &map))
        method_fail("a texture is refused", "take legal texels");
    if (span == 0)
        colors_affine(l, &texture, out);
    else
        colors_divided(l, &texture, span, out);
    for (int x = 0; x < LENGTH; x++) {
        const double u = lane_exact(l, x + .5), taken = out[x];
        worst = fmax(worst, fmax(taken - u, u - taken - 1));
    }
    return worst;
}

/* What Pel adds to the error of its method: divided.h,
 * paint_texture.h (corners are in 1/256 texel there). */
static double slack_of_pel(int span)
{
    return span == 0 ? 1. / 512 + 1. / 16384 : 1. / 256;
}

static struct worst measure(struct random *r, double ratio, int span, int n,
                            bool is_pel)
{
    struct worst w = {-1, 0, false};
    for (; n > 0; n--) {
        const struct lane l = any_lane(r, ratio);
        const double error =
            is_pel ? error_of_pel(&l, span) : error_of(&l, span);
        const double bound =
            bound_of(&l, span, is_pel) + (is_pel ? slack_of_pel(span) : 0);
        const bool is_out = error > bound;
        if (is_out > w.is_out || (is_out == w.is_out && error > w.error))
            w = (struct worst){error, bound, is_out};
    }
    return w;
}

static const double ratios[] = {1.01, 1.1, 1.5, 2, 4, 8, 16, 32, 64, 128, 256};
enum { RATIOS = sizeof ratios / sizeof *ratios };

static void put_span(struct atlas *a, int span, bool is_pel)
{
    char name[32];
    snprintf(name, sizeof name,
             span == 0   ? "%saffine"
             : span == 1 ? "%sexact"
                         : "%sspan %d",
             is_pel      ? "pel "
             : span == 1 ? "float32 "
                         : "",
             span);
    for (int i = 0; i < RATIOS; i++) {
        struct random r = atlas_random(a, (uint32_t)i);
        const struct worst w =
            measure(&r, ratios[i], span, atlas_samples(a, 2000, 60), is_pel);
        const struct figure f =
            figure_of(name, ratios[i], "error_max", w.error, "texel");
        if (span == 1 && !is_pel)
            atlas_put(a, f);
        else
            atlas_put_bound(a, f, w.bound);
    }
}

void atlas_span(struct atlas *a)
{
    for (int is_pel = 0; is_pel < 2; is_pel++)
        for (int span = 0; span <= 64; span = span < 4 ? span + 1 : span * 2)
            if (span != 3 && (is_pel || span != 2))
                put_span(a, span, is_pel);
}

void atlas_map_perspective(struct atlas *a)
{
    for (int i = 0; i < RATIOS; i++)
        for (int span = 1; span <= 64; span *= 2) {
            struct random r = atlas_random(a, (uint32_t)i);
            const struct worst w =
                measure(&r, ratios[i], span, atlas_samples(a, 2000, 60), true);
            struct figure f =
                figure_of("pel", ratios[i], "error_max", w.error, "texel");
            f.y = span;
            f.has_y = true;
            atlas_put_bound(a, f, w.bound);
        }
}
