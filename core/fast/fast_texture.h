/* The rows of a textured triangle that is not clipped, on 64-bit CPUs, and four
 * pixels of a row at a time. */
#ifndef PEL_FAST_FAST_TEXTURE_H
#define PEL_FAST_FAST_TEXTURE_H

#include "../format/vector.h"
#include "../paint/paint_texture_fetch.h"
#include "fast_triangle.h"

/* Fills a run that leaves the picture, the general way. */
static inline void pel_texture_fill_run(const struct pel_texture *p,
                                        const struct pel_surface *surface,
                                        int32_t x, int32_t n, int32_t y)
{
    const struct pel_span span = {x, x + n};
    const struct pel_spans spans = {surface, &span, y, 1, 1};
    p->base.paint.fill(&p->base.paint, &spans);
}

/* A run of n > 0 pixels, and where the first is in the picture. */
struct pel_texture_run {
    uintptr_t out;
    uint64_t u, v;
    int32_t n;
};

/* Steps from pixel to pixel, and masks of the whole texels. */
#if PEL_VECTORS

struct pel_texture_lanes {
    uint64_t du, dv;
    pel_u64x2 u, v;           /* from the first of two pixels to each */
    pel_u64x2 u_on, v_on;     /* two pixels on */
    pel_u32x4 u_mask, v_mask; /* of the whole texels */
    pel_u32x4 line;           /* from line to line, in texels: 16 bits */
};

/* `line`: texels from line to line. */
static inline struct pel_texture_lanes pel_texture_lanes_make(
    const struct pel_texture_map *map, uint32_t u_mask, uint32_t v_mask,
    int32_t line)
{
    const uint64_t du = map->u.dx, dv = map->v.dx;
    const pel_u32x4 zero = {0, 0, 0, 0};
    return (struct pel_texture_lanes){du,
                                      dv,
                                      {0, du},
                                      {0, dv},
                                      {2 * du, 2 * du},
                                      {2 * dv, 2 * dv},
                                      zero + u_mask,
                                      zero + v_mask,
                                      zero + ((uint32_t)line & 0xFFFF)};
}

/* Both coordinates of four pixels. */
struct pel_texture_four {
    pel_u64x2 u[2], v[2];
};

/* Of two, which live in registers along a run; the next two are one addition
 * further. */
struct pel_texture_two {
    pel_u64x2 u, v;
};

static PEL_ALWAYS_INLINE struct pel_texture_two pel_texture_two_at(
    const struct pel_texture_lanes *s, uint64_t u, uint64_t v)
{
    return (struct pel_texture_two){u + s->u, v + s->v};
}

/* The four pixels from these two on; then the two are those after the four. */
static PEL_ALWAYS_INLINE struct pel_texture_four pel_texture_four_next(
    struct pel_texture_two *t, const struct pel_texture_lanes *s)
{
    const pel_u64x2 u = t->u + s->u_on, v = t->v + s->v_on;
    const struct pel_texture_four f = {{t->u, u}, {t->v, v}};
    t->u = u + s->u_on;
    t->v = v + s->v_on;
    return f;
}

/* Of a run of 1 to 3 pixels: the first, the middle, and the last twice. */
static PEL_ALWAYS_INLINE struct pel_texture_four pel_texture_four_few(
    const struct pel_texture_lanes *s, const struct pel_texture_run *r)
{
    const uint64_t half = (uint64_t)r->n >> 1, last = (uint64_t)r->n - 1;
    const uint64_t u = r->u + last * s->du, v = r->v + last * s->dv;
    return (struct pel_texture_four){
        {(pel_u64x2){r->u, r->u + half * s->du}, (pel_u64x2){u, u}},
        {(pel_u64x2){r->v, r->v + half * s->dv}, (pel_u64x2){v, v}}};
}

/* Texels from texel (0, 0) to those of four pixels. `masked`: of whole texels
 * the mask is taken. So u and v are below 32,767, and v's product with the
 * stride's 16 bits, the upper half being 0, fits 31. */
static PEL_ALWAYS_INLINE void pel_texture_four_index(
    const struct pel_texture_four *f, const struct pel_texture_lanes *s,
    bool masked, int32_t index[4])
{
    pel_u32x4 u = PEL_LANES((pel_u32x4)f->u[0], (pel_u32x4)f->u[1], 1, 3, 5, 7);
    pel_u32x4 v = PEL_LANES((pel_u32x4)f->v[0], (pel_u32x4)f->v[1], 1, 3, 5, 7);
    if (masked) {
        u &= s->u_mask;
        v &= s->v_mask;
    }
    const pel_u64x2 i = (pel_u64x2)(pel_dot_s16(v, s->line) + u);
    index[0] = (int32_t)i[0];
    index[1] = (int32_t)(i[0] >> 32);
    index[2] = (int32_t)i[1];
    index[3] = (int32_t)(i[1] >> 32);
}

#else

struct pel_texture_lanes {
    uint64_t du, dv;
};

static inline struct pel_texture_lanes pel_texture_lanes_make(
    const struct pel_texture_map *map, uint32_t u_mask, uint32_t v_mask,
    int32_t line)
{
    (void)u_mask;
    (void)v_mask;
    (void)line;
    return (struct pel_texture_lanes){map->u.dx, map->v.dx};
}

#endif

/* The same for all runs of a picture. */
struct pel_texture_steps {
    struct pel_texture_lanes lanes;
    const uint8_t *memory;
    uint64_t u_end, v_end;   /* coordinates below these are inside */
    uint32_t u_mask, v_mask; /* of the whole texels */
    uint32_t set;            /* bits that 32-bit texels lack as pixels */
    ptrdiff_t stride;
};

/* Do lines lie as many texels apart as fit the 16 bits of vectors? So they do
 * but in a part of a very wide picture. */
static inline bool pel_texture_stride_fits(const struct pel_texture *p,
                                           int32_t bytes)
{
    const int32_t texels = p->stride / bytes;
    return texels >= -32768 && texels <= 32767;
}

/* Runs are inside whose texels and those `more` further right and down are.
 * `masked`: with a mask any texel is. */
static inline struct pel_texture_steps pel_texture_steps_make(
    const struct pel_texture *p, int32_t bytes, int32_t more, bool masked)
{
    const bool all_u = masked && pel_texture_is_masked(p->width, p->wrap_u);
    const bool all_v = masked && pel_texture_is_masked(p->height, p->wrap_v);
    const uint32_t um = all_u ? (uint32_t)p->width - 1 : 0xFFFF;
    const uint32_t vm = all_v ? (uint32_t)p->height - 1 : 0xFFFF;
    struct pel_texture_steps s = {
        pel_texture_lanes_make(&p->map, um, vm, p->stride / bytes),
        .memory = p->memory, .stride = p->stride, .u_mask = um, .v_mask = vm};
    s.set = p->kind == PEL_TEXTURE_XRGB8888 ? PEL_LE32(0xFF000000u) : 0;
    s.u_end = all_u ? UINT64_MAX : (uint64_t)(uint32_t)(p->width - more) << 32;
    s.v_end = all_v ? UINT64_MAX : (uint64_t)(uint32_t)(p->height - more) << 32;
    return s;
}

/* A coordinate is affine, so a run is inside when both ends are. */
static PEL_ALWAYS_INLINE bool pel_texture_run_inside(
    const struct pel_texture_run *r, const struct pel_texture_steps *s)
{
    const uint64_t last = (uint64_t)r->n - 1;
    const uint64_t u = r->u + last * s->lanes.du, v = r->v + last * s->lanes.dv;
    return r->u < s->u_end && u < s->u_end && r->v < s->v_end && v < s->v_end;
}

/* A walk down the rows; it lives in registers. */
struct pel_texture_walk {
    struct pel_fast_walk rows;
    uint64_t u, v; /* at column 0 of the next row */
};

static PEL_ALWAYS_INLINE struct pel_texture_walk pel_texture_walk_begin(
    const struct pel_texture *p, const struct pel_surface *surface,
    const struct pel_fast_triangle *t, int bytes)
{
    struct pel_texture_walk w;
    w.rows = pel_fast_walk_begin(surface, t, bytes);
    w.u = pel_texture_at(&p->map.u, 0, t->y0);
    w.v = pel_texture_at(&p->map.v, 0, t->y0);
    return w;
}

/* The next row, which may be empty: n <= 0. */
static PEL_ALWAYS_INLINE bool pel_texture_walk_next(
    struct pel_texture_walk *w, const struct pel_texture_map *map, int bytes,
    int32_t *x, struct pel_texture_run *run)
{
    if (!pel_fast_walk_next(&w->rows, x, &run->n))
        return false;
    run->out = w->rows.row + (uintptr_t)bytes * (uintptr_t)*x;
    run->u = w->u + (uint64_t)(int64_t)*x * map->u.dx;
    run->v = w->v + (uint64_t)(int64_t)*x * map->v.dx;
    w->u += map->u.dy;
    w->v += map->v.dy;
    return true;
}

#endif
