#include "sim/image/reduce.h"

#include <stdlib.h>
#include <string.h>

#include "core/format/word.h"
#include "core/paint/paint_dither.h"
#include "core/paint/paint_texture.h"
#include "core/raster/rectangle.h"
#include "sim/cli/message.h"
#include "sim/image/canvas.h"

/* Of n bits the level next to a value, as 8 bits. */
static double level(double value, int bits)
{
    const int most = (1 << bits) - 1;
    const int v = (int)(value * most / 255 + 0.5);
    return pel_widen((uint32_t)pel_max(0, pel_min(v, most)), bits);
}

static void nearest_color(const struct picture_levels *l, double alpha,
                          const double want[3], double got[4])
{
    double best = 1e9;
    for (int i = 0; i < l->colors; i++) {
        const pel_color c = l->palette[i];
        const double a = pel_alpha(c) - alpha;
        double sum = a * a;
        for (int k = 0; k < 3; k++) {
            const double d = (c >> 8 * k & 255) - want[k];
            sum += d * d;
        }
        if (sum >= best)
            continue;
        best = sum;
        for (int k = 0; k < 4; k++)
            got[k] = c >> 8 * k & 255;
    }
}

/* The color that is shown for one that is wanted: blue, green, red. */
static void show(const struct picture_levels *l, double alpha,
                 const double want[3], double got[4])
{
    got[3] = alpha;
    if (!l->format)
        nearest_color(l, alpha, want, got);
    else
        for (int k = 0; k < 3; k++)
            got[k] = level(want[k],
                           l->format->depth[l->format->depth[1] ? 2 - k : 0]);
}

static pel_color packed(const double v[4])
{
    return PEL_RGBA((uint32_t)v[2], (uint32_t)v[1], (uint32_t)v[0],
                    (uint32_t)v[3]);
}

/* What a pixel wants: its color, or the grey of it. */
static void wanted(const struct picture_levels *l, pel_color color,
                   double to[3])
{
    for (int k = 0; k < 3; k++)
        to[k] = l->format && !l->format->depth[1] ? pel_gray(color)
                                                  : color >> 8 * k & 255;
}

/* Errors of this row and the next, with a pixel more at either end. */
struct errors {
    double (*here)[3], (*below)[3];
};

static void spread(struct errors *e, int x, int ahead, const double error[3])
{
    for (int k = 0; k < 3; k++) {
        e->here[x + 1 + ahead][k] += error[k] * 7 / 16;
        e->below[x + 1 - ahead][k] += error[k] * 3 / 16;
        e->below[x + 1][k] += error[k] * 5 / 16;
        e->below[x + 1 + ahead][k] += error[k] / 16;
    }
}

static void diffuse_row(const struct picture *p, int y,
                        const struct picture_levels *l, struct errors *e)
{
    pel_color *row = picture_row(p, y);
    const int ahead = y % 2 ? -1 : 1;
    for (int i = 0; i < p->width; i++) {
        const int x = ahead > 0 ? i : p->width - 1 - i;
        double want[3], got[4], error[3];
        wanted(l, row[x], want);
        for (int k = 0; k < 3; k++) {
            want[k] += e->here[x + 1][k];
            want[k] = want[k] < -64 ? -64 : want[k] > 319 ? 319 : want[k];
        }
        show(l, pel_alpha(row[x]), want, got);
        for (int k = 0; k < 3; k++)
            error[k] = pel_alpha(row[x]) ? want[k] - got[k] : 0;
        row[x] = packed(got);
        spread(e, x, ahead, error);
    }
}

static bool diffuse(const struct picture *p, const struct picture_levels *l)
{
    const size_t size = ((size_t)p->width + 2) * 3 * sizeof(double);
    struct errors e = {calloc(1, size), calloc(1, size)};
    const bool done =
        (e.here && e.below) ||
        message_error("no memory for a row of %d pixels", p->width);
    for (int y = 0; done && y < p->height; y++) {
        void *spent = e.here;
        diffuse_row(p, y, l, &e);
        e.here = e.below;
        e.below = spent;
        memset(e.below, 0, size);
    }
    free(e.here);
    free(e.below);
    return done;
}

/* As firmware does it: a texture, dithered into the format. */
static bool order(struct picture *p, const struct pel_format *format)
{
    const struct pel_texels texels = {.colors = p->pixels,
                                      .width = p->width,
                                      .height = p->height,
                                      .opaque = true};
    static const struct pel_texture_map from_corner = PEL_TEXTURE_AT(0, 0);
    const struct pel_rect whole = {0, 0, p->width, p->height};
    struct pel_texture texture;
    struct pel_dither dither;
    struct canvas canvas;
    struct picture shown;
    if (pel_texture_init_nearest(&texture, &texels, &from_corner) != PEL_OK ||
        pel_dither_init(&dither, &texture.base.paint) != PEL_OK)
        return message_error("a picture of %d x %d pixels cannot be dithered",
                             p->width, p->height);
    if (!canvas_init(&canvas, format, p->width, p->height))
        return false;
    pel_box(&canvas.surface, &whole, &dither.paint);
    const bool done = canvas_picture(&canvas, &shown);
    canvas_free(&canvas);
    if (!done)
        return false;
    picture_free(p);
    *p = shown;
    return true;
}

/* Thresholds of the 8 x 8 matrix, -1/2 to 1/2. */
static double threshold(int x, int y)
{
    int v = 0;
    for (int bit = 0; bit < 3; bit++)
        v = v << 2 | ((x ^ y) >> bit & 1) << 1 | (y >> bit & 1);
    return (v + 0.5) / 64 - 0.5;
}

/* Every pixel by itself; of palettes the matrix moves it by a step that is as
 * wide as that many colours would lie apart. */
static void map(const struct picture *p, const struct picture_levels *l,
                double step)
{
    for (int y = 0; y < p->height; y++)
        for (int x = 0; x < p->width; x++) {
            pel_color *pixel = &picture_row(p, y)[x];
            double want[3], got[4];
            wanted(l, *pixel, want);
            for (int k = 0; k < 3; k++)
                want[k] += step * threshold(x, y);
            show(l, pel_alpha(*pixel), want, got);
            *pixel = packed(got);
        }
}

bool picture_reduce(struct picture *picture,
                    const struct picture_levels *levels,
                    enum picture_dither dither)
{
    int side = 1;
    while (levels->palette && side * side * side < levels->colors)
        side++;
    if (dither == PICTURE_DITHER_DIFFUSION)
        return diffuse(picture, levels);
    if (dither == PICTURE_DITHER_ORDERED && levels->format)
        return order(picture, levels->format);
    map(picture, levels,
        dither == PICTURE_DITHER_ORDERED && side > 1 ? 255.0 / side : 0);
    return true;
}
