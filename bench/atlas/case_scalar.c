/* Numbers by themselves: blends, hues, dithers and angles. */
#include <math.h>
#include <stdlib.h>

#include "../methods/arctangent.h"
#include "../methods/color.h"
#include "cases.h"

/* All 2^24 cases of one blend; Pel is the nearest whole number always. */
static void put_blends(struct atlas *a, const struct blend_method *m)
{
    double wrong = 0, worst = 0;
    for (int alpha = 0; alpha < 256; alpha++)
        for (int s = 0; s < 256; s++)
            for (int d = 0; d < 256; d++) {
                const int t = s * alpha + d * (255 - alpha);
                const int off = 255 * m->mix(s, d, alpha) - t;
                wrong += abs(off) > 127;
                worst = fmax(worst, abs(off));
            }
    const struct figure f =
        figure_of(m->name, 1, "wrong_percent", wrong / 167772.16, "%");
    atlas_put(a, f);
    atlas_put(a, figure_of(m->name, 1, "error_max", worst / 255, "step"));
    if (m == blend_methods)
        atlas_promise(a, wrong == 0, &f);
}

/* n blends of white with alpha 16 over black. */
static void put_fade(struct atlas *a, const struct blend_method *m, int n)
{
    double ideal = 0;
    int d = 0;
    for (int i = 0; i < n; i++) {
        d = m->mix(255, d, 16);
        ideal += (255 - ideal) * 16 / 255;
    }
    atlas_put(a, figure_of(m->name, n, "value", d, "step"));
    atlas_put(a, figure_of(m->name, n, "error", fabs(d - ideal), "step"));
}

void atlas_alpha(struct atlas *a)
{
    static const int blends[] = {1,   2,   5,   10,   20,  50,
                                 100, 200, 500, 1000, 2000};
    for (const struct blend_method *m = blend_methods; m->name; m++) {
        put_blends(a, m);
        for (size_t i = 0; i < sizeof blends / sizeof *blends; i++)
            put_fade(a, m, blends[i]);
    }
}

/* A channel of the hue's color in 15,300ths: 0 red, 1 green, 2 blue. By the
 * distance from the channel's own hue, in degrees: up to 60 the channel is v,
 * from 120 on v (1 - s), and linear between. */
static int exact_channel(int hue, int s, int v, int channel)
{
    int distance = abs(hue - 120 * channel);
    if (distance > 180)
        distance = 360 - distance;
    const int part = distance < 60 ? 0 : distance > 120 ? 60 : distance - 60;
    return v * (15300 - s * part);
}

struct hues {
    double wrong, worst, cases;
};

/* A wrong color has a channel that is not the nearest, a tie upwards. */
static void judge_hue(struct hues *out, const struct hsv_method *m, int hue,
                      const int sv[2])
{
    int rgb[3];
    bool wrong = false;
    m->rgb(hue, sv[0], sv[1], rgb);
    for (int i = 0; i < 3; i++) {
        const int exact = exact_channel(hue, sv[0], sv[1], i);
        wrong |= rgb[i] != (exact + 7650) / 15300;
        out->worst = fmax(out->worst, abs(15300 * rgb[i] - exact));
    }
    out->wrong += wrong;
    out->cases++;
}

void atlas_hsv(struct atlas *a)
{
    const int step = atlas_samples(a, 1, 5);
    for (const struct hsv_method *m = hsv_methods; m->name; m++) {
        struct hues out = {0, 0, 0};
        for (int hue = 0; hue < 360; hue++)
            for (int s = 0; s < 256; s += step)
                for (int v = 0; v < 256; v += step)
                    judge_hue(&out, m, hue, (const int[2]){s, v});
        const struct figure f = figure_of(m->name, out.cases, "wrong_percent",
                                          100 * out.wrong / out.cases, "%");
        atlas_put(a, f);
        atlas_put(a, figure_of(m->name, out.cases, "error_max",
                               out.worst / 15300, "step"));
        if (m == hsv_methods)
            atlas_promise(a, out.wrong == 0, &f);
    }
}

/* Means over blocks of side x `side` of one color. */
static void put_means(struct atlas *a, const struct dither_method *m, int side)
{
    double sum = 0, worst = 0;
    for (int c = 0; c < 256; c++)
        for (int block = 0; block < 64; block += side * side) {
            const int x0 = block / side % 8, y0 = block / side / 8 * side;
            int total = 0;
            for (int i = 0; i < side * side; i++)
                total += m->show(c, x0 + i % side, y0 + i / side);
            const double error = fabs(total / (double)(side * side) - c);
            sum += error * side * side / 64;
            worst = fmax(worst, error);
        }
    atlas_put(a, figure_of(m->name, side, "error_mean", sum / 256, "step"));
    struct figure f = figure_of(m->name, side, "error_max", worst, "step");
    /* paint_dither.h: 1/128 of the step between two levels, 8 or 9. */
    if (m == dither_methods && side == 8)
        atlas_put_bound(a, f, 9 / 128.);
    else
        atlas_put(a, f);
}

void atlas_dither(struct atlas *a)
{
    for (const struct dither_method *m = dither_methods; m->name; m++)
        for (int side = 1; side <= 8; side *= 2)
            put_means(a, m, side);
}

/* The angle in long double. */
static double error_of(const struct arctangent_method *m, int x, int y)
{
    const long double tau = 6.283185307179586476925L;
    long double exact = atan2l(y, x) / tau;
    if (exact < 0)
        exact += 1;
    const double error = fabs((double)(m->turn(x, y) - exact));
    return error > .5 ? 1 - error : error;
}

void atlas_arctangent(struct atlas *a)
{
    for (const struct arctangent_method *m = arctangent_methods; m->name; m++) {
        struct random r = atlas_random(a, 0);
        double worst = 0, sum = 0;
        const int n = atlas_samples(a, 10000000, 300000);
        for (int i = 0; i < n; i++) {
            const int side = 1 << random_between(&r, 2, 24);
            const int x = random_between(&r, -side, side);
            const int y = random_between(&r, -side, side);
            const double error = x || y ? error_of(m, x, y) : 0;
            worst = fmax(worst, error);
            sum += error;
        }
        struct figure f =
            figure_of(m->name, m->size, "error_mean", sum / n, "turn");
        atlas_put(a, f);
        f.metric = "error_max";
        f.value = worst;
        if (m == arctangent_methods)
            atlas_put_bound(a, f, ldexp(1, -30)); /* trig.h */
        else
            atlas_put(a, f);
    }
}

static double linear_of(double channel)
{
    const double c = channel / 255;
    return c <= .04045 ? c / 12.92 : pow((c + .055) / 1.055, 2.4);
}

static double channel_of(double linear)
{
    return 255 * (linear <= .0031308 ? 12.92 * linear
                                     : 1.055 * pow(linear, 1 / 2.4) - .055);
}

/* How far Pel's mixes of half and half, of values as they are, are from those
 * of light, by the difference of the two channels. */
void atlas_gamma(struct atlas *a)
{
    for (int difference = 0; difference < 256; difference += 15) {
        double worst = 0;
        for (int c = 0; c + difference < 256; c++) {
            const double light = linear_of(c) + linear_of(c + difference);
            worst = fmax(worst,
                         fabs(channel_of(light / 2) - (c + difference / 2.)));
        }
        atlas_put(
            a, figure_of("pel", difference, "difference_max", worst, "step"));
    }
}
