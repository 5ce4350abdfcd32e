#include "paint_perspective.h"

#include "vector.h"

/* A place in the texture, 2^-32 texels. */
struct place {
    uint64_t u, v;
};

/* n / w, in [-1, 1] but for rounding, as 2^-31; inverse is 2^63 / w. */
static int64_t ratio(int64_t n, uint64_t inverse)
{
    const uint64_t q = (uint64_t)pel_size_of(n) * inverse >> 32;
    return n < 0 ? -(int64_t)q : (int64_t)q;
}

/* base 2^16 + part 2^(reach - 15), and the part of a texel by which that may
 * be too low: a place on a border of texels stays in the upper one. */
static uint64_t coordinate(int32_t base, int64_t part, int reach)
{
    return (uint64_t)(int64_t)base * 65536 +
           (uint64_t)(part * 131072 >> (32 - reach)) +
           ((uint64_t)1 << pel_max(reach - 12, 0));
}

/* False where w is not above 0 or u or v would be out of reach: outside of the
 * triangle. w and the others are cut to 32 bits, w with its first one set. */
static bool divide(const struct pel_perspective *p, int32_t x, int32_t y,
                   struct place *place)
{
    int64_t w = (int64_t)pel_plane_at(&p->w, x, y);
    int64_t u = (int64_t)pel_plane_at(&p->u, x, y);
    int64_t v = (int64_t)pel_plane_at(&p->v, x, y);
    if (w < INT64_C(1) << 26 || w >> 55 || pel_size_of(u) > w + (w >> 1) ||
        pel_size_of(v) > w + (w >> 1))
        return false;
    const int shift = pel_bits_of((uint64_t)w) - 26;
    const uint64_t divisor = (uint64_t)(w * 64 >> shift);
    const uint64_t inverse = (UINT64_C(1) << 63) / divisor;
    place->u = coordinate(p->u0, ratio(u * 64 >> shift, inverse), p->reach_u);
    place->v = coordinate(p->v0, ratio(v * 64 >> shift, inverse), p->reach_v);
    return true;
}

/* The texture's map makes x and y u and v in 1/65,536 texel. */
static void each(const struct pel_perspective *p, const struct pel_row *row,
                 int32_t y, pel_color *out)
{
    const struct pel_color_paint *texture = &p->texture.base;
    for (int32_t x = row->x0; x < row->x1; x++, out++) {
        struct place at = {(uint64_t)(int64_t)p->u0 * 65536,
                           (uint64_t)(int64_t)p->v0 * 65536};
        divide(p, x, y, &at);
        texture->colors(texture, (int32_t)((int64_t)at.u >> 16),
                        (int32_t)((int64_t)at.v >> 16), 1, out);
    }
}

/* Differences of places, below 2^32 texels 2^-32 in size, by 1 / span. */
static uint64_t step_of(uint64_t from, uint64_t to, int32_t span)
{
    return (uint64_t)((int64_t)(to - from) / span);
}

/* n places from `at` on. Both ways read the same texels, with the same weights:
 * what is beyond 2^-16 has no part in them. */
#if PEL_FAST_64BIT
static void walk(const struct pel_perspective *p, const struct place *at,
                 const struct place *step, int32_t n, pel_color *out)
{
    struct pel_texture t = p->texture;
    t.map.u = (struct pel_texture_plane){at->u, step->u, 0};
    t.map.v = (struct pel_texture_plane){at->v, step->v, 0};
    t.base.colors(&t.base, 0, 0, n, out);
}
#else
static void walk(const struct pel_perspective *p, struct place *at,
                 const struct place *step, int32_t n, pel_color *out)
{
    const struct pel_color_paint *texture = &p->texture.base;
    for (; n > 0; n--, out++) {
        texture->colors(texture, (int32_t)((int64_t)at->u >> 16),
                        (int32_t)((int64_t)at->v >> 16), 1, out);
        at->u += step->u;
        at->v += step->v;
    }
}
#endif

/* Pixels of `row` in the span that begins at x. */
static void linear(const struct pel_perspective *p, const struct pel_row *row,
                   int32_t y, pel_color *out)
{
    const int32_t x = row->x0 & ~(p->span - 1);
    struct place at, step; /* first the span's end, then a pixel's part */
    if (!divide(p, x, y, &at) || !divide(p, x + p->span, y, &step)) {
        each(p, row, y, out);
        return;
    }
    step.u = step_of(at.u, step.u, p->span);
    step.v = step_of(at.v, step.v, p->span);
    at.u += (uint64_t)(row->x0 - x) * step.u;
    at.v += (uint64_t)(row->x0 - x) * step.v;
    walk(p, &at, &step, row->x1 - row->x0, out);
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_perspective *p = (const void *)paint;
    struct pel_row part = {x, x + n};
    for (; part.x0 < x + n; part.x0 = part.x1) {
        part.x1 = pel_min(x + n, (part.x0 | (p->span - 1)) + 1);
        linear(p, &part, y, out + (part.x0 - x));
    }
}

static void exact_colors(const struct pel_color_paint *paint, int32_t x,
                         int32_t y, int32_t n, pel_color *out)
{
    const struct pel_row row = {x, x + n};
    each((const void *)paint, &row, y, out);
}

/* value[i] w[i] 2^-reach with 2^reach above the largest value. */
static void set_plane(struct pel_plane *plane,
                      const struct pel_plane_setup *setup,
                      const int64_t value[3], const int32_t w[3],
                      uint8_t *reach)
{
    int32_t scaled[3];
    *reach = (uint8_t)pel_bits_of(pel_reach_of(value));
    for (int i = 0; i < 3; i++)
        scaled[i] = (int32_t)pel_scale_down(value[i] * w[i], *reach);
    pel_plane_set(plane, setup, scaled);
}

/* A triangle that is thinner than a pixel has gradients that may wrap on the
 * way to the end of a span. Otherwise they are below 2^31 a pixel. */
static bool thin(const struct pel_plane_setup *s)
{
    int32_t x = pel_max(pel_max(s->ab.x, s->ac.x), 0) -
                pel_min(pel_min(s->ab.x, s->ac.x), 0);
    int32_t y = pel_max(s->ab.y, s->ac.y);
    return s->area < (uint64_t)256 * (uint32_t)pel_max(x, y);
}

void pel_perspective_init(struct pel_perspective *paint,
                          const struct pel_texture *texture,
                          const struct pel_plane_setup *setup,
                          const struct pel_texture_corner corner[3],
                          int32_t span)
{
    const int32_t near =
        pel_min(pel_min(corner[0].z, corner[1].z), corner[2].z);
    int32_t w[3];
    int64_t u[3], v[3];
    paint->texture = *texture;
    paint->u0 = corner[setup->first].u;
    paint->v0 = corner[setup->first].v;
    for (int i = 0; i < 3; i++) {
        const int64_t z = corner[i].z;
        w[i] = (int32_t)(((int64_t)near * PEL_COSINE_ONE + z / 2) / z);
        u[i] = (int64_t)corner[i].u - paint->u0;
        v[i] = (int64_t)corner[i].v - paint->v0;
    }
    pel_plane_set(&paint->w, setup, w);
    set_plane(&paint->u, setup, u, w, &paint->reach_u);
    set_plane(&paint->v, setup, v, w, &paint->reach_v);
    paint->texture.map.u = (struct pel_texture_plane){0, 65536, 0};
    paint->texture.map.v = (struct pel_texture_plane){0, 0, 65536};
    paint->span = span;
    pel_color_paint_init(&paint->base,
                         span == PEL_SPAN_EXACT || thin(setup) ? exact_colors
                                                               : colors,
                         texture->base.opaque);
}
