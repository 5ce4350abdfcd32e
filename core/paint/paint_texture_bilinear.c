#include "paint_texture_fetch.h"

/* a (256 - f) + b f in both 16-bit halves of a word: at most 255 * 256. */
static PEL_HOT uint32_t mix_halves(uint32_t a, uint32_t b, uint32_t f)
{
    return a * 256 + (b - a) * f;
}

/* a (256 - f) + b f, rounded to 1/65,536, of halves up to 255 * 256. */
static PEL_HOT uint32_t mix_lines(uint32_t a, uint32_t b, uint32_t f)
{
    uint32_t low = (a & 0xFFFFu) * (256 - f) + (b & 0xFFFFu) * f + 32768;
    uint32_t high = (a >> 16) * (256 - f) + (b >> 16) * f + 32768;
    return low >> 16 | (high & 0xFFFF0000u);
}

/* The four texels a b over c d with the weights fu / 256, fv / 256. */
static PEL_STEP_OF_FEW pel_color mixed(const pel_color t[4], uint32_t fu,
                                       uint32_t fv)
{
    const uint32_t mask = 0xFF00FFu;
    uint32_t rb = mix_lines(mix_halves(t[0] & mask, t[1] & mask, fu),
                            mix_halves(t[2] & mask, t[3] & mask, fu), fv);
    uint32_t ag =
        mix_lines(mix_halves(t[0] >> 8 & mask, t[1] >> 8 & mask, fu),
                  mix_halves(t[2] >> 8 & mask, t[3] >> 8 & mask, fu), fv);
    return rb | ag << 8;
}

static inline uint32_t weight(uint64_t at)
{
    return (uint32_t)(at >> 24) & 255;
}

/* The texels that a coordinate lies between: the first, and 65,536 times the
 * second. */
static PEL_STEP uint32_t texels_at(uint64_t *at, int32_t size, int wrap)
{
    const struct pel_texture_side side = pel_texture_side_of(size, wrap);
    const int32_t i = pel_texture_index(at, side.period);
    const int32_t next = pel_texture_texel(side, i + (i < INT32_MAX));
    return (uint32_t)pel_texture_texel(side, i) | (uint32_t)next << 16;
}

/* Are they as they lie in memory? */
static inline bool are_inner(uint32_t texels)
{
    return texels >> 16 == (texels & 0xFFFF) + 1;
}

/* How many of n pixels: where `stop`, it stops before one that is inside. */
static int32_t outer_run(const struct pel_texture *p,
                         struct pel_texture_axes *a, int32_t n, bool stop,
                         pel_color *out)
{
    int32_t k = 0;
    for (; k < n; k++, pel_texture_axes_step(a, p)) {
        const uint32_t u = texels_at(&a->u, p->width, p->wrap_u);
        const uint32_t v = texels_at(&a->v, p->height, p->wrap_v);
        if (stop && are_inner(u) && are_inner(v))
            break;
        const int32_t i0 = (int32_t)(u & 0xFFFF), i1 = (int32_t)(u >> 16);
        const int32_t j0 = (int32_t)(v & 0xFFFF), j1 = (int32_t)(v >> 16);
        const pel_color t[4] = {
            pel_texel(p, p->kind, i0, j0), pel_texel(p, p->kind, i1, j0),
            pel_texel(p, p->kind, i0, j1), pel_texel(p, p->kind, i1, j1)};
        out[k] = mixed(t, weight(a->u), weight(a->v));
    }
    return k;
}

/* How many of n pixels come before the first that is not inside. */
static int32_t inner_pixels(uint64_t at, uint64_t step, int32_t size, int32_t n)
{
    const uint64_t end = (uint64_t)(uint32_t)(size - 1) << 32;
    if (at >= end || step == 0)
        return at < end ? n : 0;
    const uint64_t steps = step >> 63 ? at / (0 - step) : (end - 1 - at) / step;
    return steps < (uint32_t)n ? (int32_t)steps + 1 : n;
}

/* The four texels around the coordinates, inside the picture. */
static PEL_STEP_OR_INLINE void texels_around(const struct pel_texture *p,
                                             int kind,
                                             const struct pel_texture_axes *a,
                                             pel_color t[4])
{
    const int32_t i = (int32_t)(a->u >> 32), j = (int32_t)(a->v >> 32);
    t[0] = pel_texel(p, kind, i, j);
    t[1] = pel_texel(p, kind, i + 1, j);
    t[2] = pel_texel(p, kind, i, j + 1);
    t[3] = pel_texel(p, kind, i + 1, j + 1);
}

/* A run that does not leave the picture. */
static PEL_ALWAYS_INLINE void inner_run(const struct pel_texture *p, int kind,
                                        struct pel_texture_axes *a, int32_t n,
                                        pel_color *out)
{
    for (; n > 0; n--, pel_texture_axes_step(a, p)) {
        pel_color t[4];
        texels_around(p, kind, a, t);
        *out++ = mixed(t, weight(a->u), weight(a->v));
    }
}

static void inner(const struct pel_texture *p, struct pel_texture_axes *a,
                  int32_t n, pel_color *out)
{
    if (PEL_SHORT_STACK)
        inner_run(p, p->kind, a, n, out);
    else if (!PEL_FAST_FILLS || !PEL_VECTORS ||
             !pel_texture_bilinear_run(p, a, n, out))
        pel_texture_run(p, a, n, out, inner_run);
}

/* Does the coordinate take four pixels or more from end to end of the picture?
 * Of shorter parts a pixel costs more than one outside. */
static inline bool is_slow(int32_t size, uint64_t step)
{
    const uint64_t length = step >> 63 ? 0 - step : step;
    return length <= (uint64_t)(uint32_t)size << 30;
}

/* By parts that lie inside the picture, or one of its repetitions, and seams
 * between them. */
static PEL_NOINLINE void parts(const struct pel_texture *p,
                               struct pel_texture_axes *a, int32_t n,
                               pel_color *out)
{
    for (int32_t part; n > 0; n -= part, out += part) {
        part = inner_pixels(a->u, p->map.u.dx, p->width, n);
        part = inner_pixels(a->v, p->map.v.dx, p->height, part);
        if (part == 0) {
            part = outer_run(p, a, n, true, out);
            continue;
        }
        struct pel_texture_axes run = *a;
        inner(p, &run, part, out);
        a->u += pel_times(p->map.u.dx, part);
        a->v += pel_times(p->map.v.dx, part);
    }
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_texture *p = (const void *)paint;
    struct pel_texture_axes a;
    pel_texture_axes_start(&a, p, x, y);
    a.u -= PEL_TEXTURE_HALF_BACK;
    a.v -= PEL_TEXTURE_HALF_BACK;
    if (pel_texture_has_run(p) && pel_texture_axes_inside(&a, p, n, 1))
        inner(p, &a, n, out);
    else if (PEL_64BIT && is_slow(p->width, p->map.u.dx) &&
             is_slow(p->height, p->map.v.dx))
        parts(p, &a, n, out);
    else
        outer_run(p, &a, n, false, out);
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    if (!PEL_FAST_FILLS || !PEL_VECTORS ||
        !pel_texture_bilinear_fast((const void *)paint, spans))
        pel_color_paint_fill(paint, spans);
}

enum pel_status pel_texture_init_bilinear(struct pel_texture *paint,
                                          const struct pel_texels *texels,
                                          const struct pel_texture_map *map)
{
    enum pel_status status = pel_texture_set(paint, texels, map);
    if (status != PEL_OK)
        return status;
    pel_color_paint_init(&paint->base, colors, paint->base.opaque);
    if (PEL_FAST_FILLS && PEL_VECTORS)
        paint->base.paint.fill = fill;
    return PEL_OK;
}
