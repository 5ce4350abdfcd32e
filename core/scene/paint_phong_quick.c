#include "paint_phong_quick.h"

enum { ONE_BITS = PEL_QUICK_BITS, ONE = 1 << ONE_BITS };

/* 2^-28, below 8 in size: 64 bits where those cost nothing, which saves
 * extensions of the sign. */
#if PEL_64BIT
typedef int64_t number;

static inline number times(number a, number b)
{
    return a * b >> ONE_BITS;
}
#else
typedef int32_t number;

static number times(number a, number b)
{
    return (number)(pel_long_product(a, b) >> ONE_BITS);
}
#endif

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
    at->eye = 0;
    if (p->dull)
        return;
    const number all = ONE + times(d, ONE + times(d, ONE + times(d, ONE + d)));
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
    for (int32_t i = 0; i < p->lights->count; i++)
        add(p, i, &at, channels, sum);
}

/* A run of pixels of one row, and in how many channels its light differs. */
struct run {
    const struct pel_phong_quick *paint;
    int32_t x, y, n;
    int channels;
};

/* Channel k, blue first, of light on a surface of 1/256 steps: 2^-24 of a step,
 * below 2^52. */
static inline uint64_t lit_channel(const struct run *r, int k,
                                   const struct pel_light_sum *sum,
                                   uint64_t surface)
{
    const int c = r->channels == 1 ? 0 : 2 - k;
    const uint64_t lit = surface * (uint32_t)sum->surface[c];
    return sum->plain[c] ? lit + UINT64_C(65280) * (uint32_t)sum->plain[c]
                         : lit;
}

static inline pel_color rounded(uint64_t v)
{
    v = (v + (UINT64_C(128) << 16)) >> 24;
    return v < 255 ? (pel_color)v : 255;
}

/* Channel k of the surface at the run's first pixel, 1/256 step. */
static inline uint64_t surface_at(const struct run *r, int k, pel_color under)
{
    const struct pel_phong_quick *p = r->paint;
    if (p->surface)
        return (under >> 8 * k & 255) << 8;
    number own = p->color[0][k];
    if (!p->one_color)
        for (int i = 0; i < 2; i++)
            own +=
                times(pel_plane_whole(pel_plane_at(&p->weight[i], r->x, r->y)),
                      p->color[i + 1][k]);
    return (uint64_t)own;
}

/* The color of the run's first pixel. */
static inline pel_color lit_color(const struct run *r, pel_color under,
                                  const struct pel_light_sum *sum)
{
    pel_color lit = (uint32_t)r->paint->alpha << 24;
    if (r->paint->surface)
        lit = pel_round_div255(pel_alpha(under) * r->paint->alpha) << 24;
    PEL_UNROLL
    for (int k = 0; k < 3; k++)
        lit |= rounded(lit_channel(r, k, sum, surface_at(r, k, under)))
               << 8 * k;
    return lit;
}

/* Puts the colors of a run whose light changes by `step` a pixel. */
static inline void put(const struct run *run, struct pel_light_sum *sum,
                       const struct pel_light_sum *step, pel_color *out)
{
    struct run r = *run;
    for (; r.n > 0; r.n--, r.x++, out++) {
        *out = lit_color(&r, *out, sum);
        for (int k = 0; k < r.channels; k++) {
            sum->surface[k] += step->surface[k];
            sum->plain[k] += step->plain[k];
        }
    }
}

/* The same where the surface has one color: the lit channels change by the same
 * step at each pixel. */
static inline void put_one(const struct run *r, const struct pel_light_sum *sum,
                           const struct pel_light_sum *step, pel_color *out)
{
    uint64_t at[3], by[3];
    PEL_UNROLL
    for (int k = 0; k < 3; k++) {
        const uint64_t own = (uint32_t)r->paint->color[0][k];
        const int c = r->channels == 1 ? 0 : 2 - k;
        at[k] = lit_channel(r, k, sum, own);
        by[k] = own * (uint64_t)(int64_t)step->surface[c] +
                65280 * (uint64_t)(int64_t)step->plain[c];
    }
    for (const pel_color *end = out + r->n; out < end; out++) {
        *out = rounded(at[0]) | rounded(at[1]) << 8 | rounded(at[2]) << 16 |
               (uint32_t)r->paint->alpha << 24;
        PEL_UNROLL
        for (int k = 0; k < 3; k++)
            at[k] += by[k];
    }
}

/* v / 2^bits, cut towards 0: light stays between that of the two ends. */
static inline int32_t part_of(int32_t v, int bits)
{
    return v < 0 ? -(-v >> bits) : v >> bits;
}

/* The change a pixel between the ends of a span, and what `from` has become
 * after n pixels. */
static inline void set_line(const struct run *r, int32_t n,
                            struct pel_light_sum *from,
                            const struct pel_light_sum *to,
                            struct pel_light_sum *step)
{
    for (int k = 0; k < r->channels; k++) {
        const int bits = r->paint->span;
        step->surface[k] = part_of(to->surface[k] - from->surface[k], bits);
        step->plain[k] = part_of(to->plain[k] - from->plain[k], bits);
        from->surface[k] += n * step->surface[k];
        from->plain[k] += n * step->plain[k];
    }
}

/* Light at the pixels that are multiples of a span, and linear between. */
static PEL_INLINE_KINDS void light_spans(const struct run *run, pel_color *out)
{
    const struct pel_phong_quick *p = run->paint;
    const int32_t span = (int32_t)(UINT32_C(1) << p->span);
    struct pel_light_sum from, to, step;
    struct run r = *run;
    int32_t begin = r.x & -span, left = r.n;
    sum_at(p, begin, r.y, r.channels, &to);
    for (; left > 0; left -= r.n, out += r.n, r.x = begin) {
        r.n = pel_min(begin + span - r.x, left);
        from = to;
        sum_at(p, begin + span, r.y, r.channels, &to);
        set_line(&r, r.x - begin, &from, &to, &step);
        if (p->one_color && !p->surface)
            put_one(&r, &from, &step, out);
        else
            put(&r, &from, &step, out);
        begin += span;
    }
}

static PEL_INLINE_KINDS void light(struct run r, pel_color *out)
{
    struct pel_light_sum sum;
    if (r.paint->span > 0)
        light_spans(&r, out);
    else
        for (; r.n > 0; r.n--, r.x++, out++) {
            sum_at(r.paint, r.x, r.y, r.channels, &sum);
            *out = lit_color(&r, *out, &sum);
        }
}

void pel_phong_quick_colors(const struct pel_color_paint *paint, int32_t x,
                            int32_t y, int32_t n, pel_color *out)
{
    const struct pel_phong_quick *p = (const void *)paint;
    if (p->surface)
        p->surface->colors(p->surface, x, y, n, out);
    if (p->gray)
        light((struct run){p, x, y, n, 1}, out);
    else
        light((struct run){p, x, y, n, 3}, out);
}
