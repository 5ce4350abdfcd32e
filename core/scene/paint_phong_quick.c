#include "paint_phong_quick.h"

#include "../base/sqrt.h"

/* 2^-28, below 8 in size: 64 bits where those cost nothing, which saves
 * extensions of the sign. */
#if PEL_64BIT
typedef int64_t number;
#else
typedef int32_t number;
#endif

enum { ONE_BITS = 28, ONE = 1 << ONE_BITS };

static inline number times(number a, number b)
{
    return (number)((int64_t)a * b >> ONE_BITS);
}

static inline number value_at(const struct pel_polynomial *p, number a,
                              number b)
{
    const int32_t *k = p->k;
    return k[0] + times(a, k[1] + times(a, k[3]) + times(b, k[4])) +
           times(b, k[2] + times(b, k[5]));
}

/* Where k3 to k5 are 0. */
static inline number linear_at(const struct pel_polynomial *p, number a,
                               number b)
{
    return p->k[0] + times(a, p->k[1]) + times(b, p->k[2]);
}

/* v^n, v from 0 to 1. */
static inline number power(number v, int32_t n)
{
    number result = ONE;
    for (;; v = times(v, v)) {
        if (n & 1)
            result = times(result, v);
        n >>= 1;
        if (n == 0)
            return result;
    }
}

/* A point in the triangle: the weights, and what all lights share: 1 / |n| - 1
 * and 2 (n.V) / n.n. */
struct place {
    number a, b, longer, eye;
};

static inline void set_place(const struct pel_phong_quick *p, uint64_t a,
                             uint64_t b, struct place *at)
{
    at->a = pel_plane_whole(a);
    at->b = pel_plane_whole(b);
    const number d = value_at(&p->d, at->a, at->b);
    at->longer =
        times(d, ONE / 2 + times(d, 3 * (ONE / 8) + (d >> 2) + (d >> 4)));
    if (p->dull)
        return;
    const number all = ONE + times(d, ONE + times(d, ONE + d));
    at->eye = times(value_at(&p->eye, at->a, at->b), 2 * all);
}

static inline number dot_at(const struct pel_phong_quick *p, int32_t i, int k,
                            const struct place *at)
{
    const struct pel_polynomial *of = &p->light[i].of[k];
    return p->lights->light[i].directional ? linear_at(of, at->a, at->b)
                                           : value_at(of, at->a, at->b);
}

/* Adds a light to the first channels of the sum. */
static inline void add(const struct pel_phong_quick *p, int32_t i,
                       const struct place *at, int channels,
                       struct pel_light_sum *sum)
{
    const struct pel_lighting *lighting = p->lights->lighting;
    const struct pel_mesh_light *light = &p->lights->light[i];
    const number nl = dot_at(p, i, 0, at);
    if (nl > 0)
        for (int k = 0; k < channels; k++)
            sum->surface[k] += (pel_factor)times(light->diffuse[k],
                                                 nl + times(nl, at->longer));
    if (p->dull || (nl <= 0 && lighting->no_back_highlights))
        return;
    const number w = times(nl, at->eye) - dot_at(p, i, 1, at);
    if (w <= 0)
        return;
    const number bright = power(w < ONE ? w : ONE, lighting->shininess);
    pel_factor *highlight =
        lighting->plain_highlights ? sum->plain : sum->surface;
    for (int k = 0; k < channels; k++)
        highlight[k] += (pel_factor)times(light->specular[k], bright);
}

/* The light of a pixel, in as many channels as differ. */
static PEL_INLINE_KINDS void sum_at(const struct pel_phong_quick *p, int32_t x,
                                    int32_t y, int channels,
                                    struct pel_light_sum *sum)
{
    struct place at;
    set_place(p, pel_plane_at(&p->weight[0], x, y),
              pel_plane_at(&p->weight[1], x, y), &at);
    *sum = (struct pel_light_sum){{0, 0, 0}, {0, 0, 0}};
    for (int k = 0; k < channels; k++)
        sum->surface[k] = p->lights->ambient[k];
    for (int32_t i = 0; i < p->lights->lighting->lights; i++)
        add(p, i, &at, channels, sum);
}

/* Channel k, blue first, of light on a surface of 1/256 steps: 2^-24 of a step
 * over 1/2, below 2^52. */
static inline uint64_t lit_channel(const struct pel_phong_quick *p, int k,
                                   const struct pel_light_sum *sum,
                                   uint64_t surface, int channels)
{
    const int c = channels == 1 ? 0 : 2 - k;
    const uint64_t lit = surface * (uint32_t)sum->surface[c];
    if (!p->lights->lighting->plain_highlights)
        return lit;
    return lit + UINT64_C(65280) * (uint32_t)sum->plain[c];
}

static inline pel_color rounded(uint64_t v)
{
    v = (v + (UINT64_C(128) << 16)) >> 24;
    return v < 255 ? (pel_color)v : 255;
}

/* The color of a pixel. */
static inline pel_color lit_color(const struct pel_phong_quick *p, int32_t x,
                                  int32_t y, pel_color under, int channels,
                                  const struct pel_light_sum *sum)
{
    pel_color lit = (uint32_t)p->alpha << 24;
    if (p->surface)
        lit = pel_round_div255(pel_alpha(under) * p->alpha) << 24;
    for (int k = 0; k < 3; k++) {
        number own = p->color[0][k];
        if (p->surface)
            own = (number)(under >> 8 * k & 255) << 8;
        else if (!p->one_color)
            for (int i = 0; i < 2; i++)
                own += times(pel_plane_whole(pel_plane_at(&p->weight[i], x, y)),
                             p->color[i + 1][k]);
        lit |= rounded(lit_channel(p, k, sum, (uint64_t)own, channels))
               << 8 * k;
    }
    return lit;
}

/* Puts n colors of row y from x on, whose light changes by `step` a pixel. */
static inline void put(const struct pel_phong_quick *p, int32_t x, int32_t y,
                       int32_t n, int channels, struct pel_light_sum *sum,
                       const struct pel_light_sum *step, pel_color *out)
{
    for (; n > 0; n--, x++, out++) {
        *out = lit_color(p, x, y, *out, channels, sum);
        for (int k = 0; k < channels; k++) {
            sum->surface[k] += step->surface[k];
            sum->plain[k] += step->plain[k];
        }
    }
}

/* The same on one color: its channels change by so much themselves. */
static inline void put_one(const struct pel_phong_quick *p, int32_t n,
                           int channels, const struct pel_light_sum *sum,
                           const struct pel_light_sum *step, pel_color *out)
{
    uint64_t at[3], by[3];
    for (int k = 0; k < 3; k++) {
        const uint64_t own = (uint32_t)p->color[0][k];
        const int c = channels == 1 ? 0 : 2 - k;
        at[k] = lit_channel(p, k, sum, own, channels);
        by[k] = own * (uint64_t)(int64_t)step->surface[c] +
                65280 * (uint64_t)(int64_t)step->plain[c];
    }
    for (; n > 0; n--, out++) {
        *out = rounded(at[0]) | rounded(at[1]) << 8 | rounded(at[2]) << 16 |
               (uint32_t)p->alpha << 24;
        for (int k = 0; k < 3; k++)
            at[k] += by[k];
    }
}

/* A part of 2^bits, rounded towards 0, so that light that fades does not fall
 * below 0. */
static inline pel_factor part_of(pel_factor way, int bits)
{
    return (way + (way < 0 ? (pel_factor)(UINT32_C(1) << bits) - 1 : 0)) >>
           bits;
}

/* The change a pixel on the way of 2^bits pixels, and what `from` has become
 * after n of them. */
static inline void set_line(struct pel_light_sum *from,
                            const struct pel_light_sum *to, int bits, int32_t n,
                            int channels, struct pel_light_sum *step)
{
    for (int k = 0; k < channels; k++) {
        step->surface[k] = part_of(to->surface[k] - from->surface[k], bits);
        step->plain[k] = part_of(to->plain[k] - from->plain[k], bits);
        from->surface[k] += n * step->surface[k];
        from->plain[k] += n * step->plain[k];
    }
}

/* Light at the pixels that are multiples of a span, and linear between. */
static PEL_INLINE_KINDS void light_spans(const struct pel_phong_quick *p,
                                         int32_t x, int32_t y, int32_t n,
                                         pel_color *out, int channels)
{
    const int32_t span = (int32_t)(UINT32_C(1) << p->span);
    struct pel_light_sum from, to, step;
    int32_t begin = x & -span;
    sum_at(p, begin, y, channels, &to);
    while (n > 0) {
        const int32_t part = pel_min(begin + span - x, n);
        from = to;
        sum_at(p, begin + span, y, channels, &to);
        set_line(&from, &to, p->span, x - begin, channels, &step);
        if (p->one_color && !p->surface)
            put_one(p, part, channels, &from, &step, out);
        else
            put(p, x, y, part, channels, &from, &step, out);
        n -= part;
        out += part;
        begin += span;
        x = begin;
    }
}

static PEL_INLINE_KINDS void light(const struct pel_phong_quick *p, int32_t x,
                                   int32_t y, int32_t n, pel_color *out,
                                   int channels)
{
    struct pel_light_sum sum;
    if (p->span > 0)
        light_spans(p, x, y, n, out, channels);
    else
        for (; n > 0; n--, x++, out++) {
            sum_at(p, x, y, channels, &sum);
            *out = lit_color(p, x, y, *out, channels, &sum);
        }
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_phong_quick *p = (const void *)paint;
    if (p->surface)
        p->surface->colors(p->surface, x, y, n, out);
    if (p->gray)
        light(p, x, y, n, out, 1);
    else
        light(p, x, y, n, out, 3);
}

/* A direction, or any vector, that is linear: at vertex 0, and what is added at
 * the others. */
typedef int32_t field[3][3];

static int32_t dot(const int32_t a[3], const int32_t b[3])
{
    return (int32_t)(pel_dot(a, b) >> ONE_BITS);
}

/* The product of two fields. */
static void multiply(field v, field w, struct pel_polynomial *p)
{
    p->k[0] = dot(v[0], w[0]);
    p->k[1] = dot(v[0], w[1]) + dot(v[1], w[0]);
    p->k[2] = dot(v[0], w[2]) + dot(v[2], w[0]);
    p->k[3] = dot(v[1], w[1]);
    p->k[4] = dot(v[1], w[2]) + dot(v[2], w[1]);
    p->k[5] = dot(v[2], w[2]);
}

static void to_field(field v)
{
    for (int i = 1; i < 3; i++)
        for (int k = 0; k < 3; k++)
            v[i][k] -= v[0][k];
}

/* Scaled so that `length` is 1. */
static void set_normals(const struct pel_lit_corners *corners, field normal)
{
    int shift;
    const uint32_t inverse = pel_inverse_root(corners->length, &shift);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            normal[i][k] =
                pel_scaled(corners->normal[i][k], (int32_t)(inverse >> 1),
                           61 - ONE_BITS - shift);
    to_field(normal);
}

/* The directions to a place. */
static void set_directions(const struct pel_lit_corners *corners,
                           const int32_t to[3], field v)
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            v[i][k] = to[k] - corners->position[i][k];
        pel_normalize_fast(v[i], v[i]);
        for (int k = 0; k < 3; k++)
            v[i][k] >>= 30 - ONE_BITS;
    }
    to_field(v);
}

static void set_light(struct pel_phong_quick *p, int32_t i,
                      const struct pel_lit_corners *corners, field normal,
                      field eye)
{
    const struct pel_mesh_light *from = &p->lights->light[i];
    field way = {{0}, {0}, {0}};
    if (from->directional)
        for (int k = 0; k < 3; k++)
            way[0][k] = from->at[k] >> (30 - ONE_BITS);
    else
        set_directions(corners, from->at, way);
    multiply(normal, way, &p->light[i].of[0]);
    multiply(eye, way, &p->light[i].of[1]);
}

static bool equal(const pel_factor v[3])
{
    return v[0] == v[1] && v[1] == v[2];
}

static bool is_gray(const struct pel_mesh_lights *lights)
{
    bool gray = equal(lights->ambient);
    for (int32_t i = 0; i < lights->lighting->lights; i++)
        gray = gray && equal(lights->light[i].diffuse) &&
               equal(lights->light[i].specular);
    return gray;
}

void pel_phong_quick_init(struct pel_phong_quick *paint,
                          const struct pel_mesh_lights *lights,
                          const struct pel_lit_corners *corners,
                          const struct pel_color_paint *surface,
                          const pel_color color[3])
{
    field normal, eye;
    paint->base.colors = colors;
    paint->lights = lights;
    paint->surface = surface;
    paint->gray = is_gray(lights);
    set_normals(corners, normal);
    set_directions(corners, lights->eye, eye);
    multiply(normal, normal, &paint->d);
    paint->d.k[0] -= ONE;
    for (int k = 0; k < 6; k++)
        paint->d.k[k] = -paint->d.k[k];
    multiply(normal, eye, &paint->eye);
    for (int32_t i = 0; i < lights->lighting->lights; i++)
        set_light(paint, i, corners, normal, eye);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            paint->color[i][k] = (int32_t)((color[i] >> 8 * k & 255) << 8);
    }
    paint->one_color = ((color[0] ^ color[1]) | (color[0] ^ color[2])) == 0;
    to_field(paint->color);
}
