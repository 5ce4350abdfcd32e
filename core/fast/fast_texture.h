/* Runs of textures by vectors, four pixels at a time. */
#ifndef PEL_FAST_FAST_TEXTURE_H
#define PEL_FAST_FAST_TEXTURE_H

#include "../format/vector.h"
#include "../paint/paint_texture_fetch.h"

#if PEL_FAST_FILLS && PEL_VECTORS

/* A run of n > 0 pixels: where the first and the last are in the picture. */
struct pel_texture_run {
    uint64_t u, v, u_last, v_last;
    uintptr_t out; /* the address of the first */
    int32_t n;
};

/* The same for all runs of a picture. */
struct pel_texture_steps {
    uint64_t du, dv;          /* from pixel to pixel */
    pel_u64x2 u, v;           /* from the first of two pixels to each */
    pel_u64x2 u_on, v_on;     /* two pixels on */
    uint64_t u_end, v_end;    /* coordinates below these are inside */
    pel_u32x4 u_mask, v_mask; /* of the whole texels */
    pel_u32x4 line;           /* from line to line, in texels: 16 bits */
    ptrdiff_t stride;
    const uint8_t *memory;
    uint32_t set; /* bits that 32-bit texels lack as pixels */
};

/* Both coordinates of four pixels. */
struct pel_texture_four {
    pel_u64x2 u[2], v[2];
};

/* How runs are written: constant in the loop over spans. */
struct pel_texture_writer {
    int32_t texel_bytes, pixel_bytes;
    int32_t more; /* 1: it reads the texels further right and down, too;
                     0: it repeats the picture where a mask does */
};

/* Do lines lie as many texels apart as fit the 16 bits of vectors? So they do
 * but in a part of a very wide picture. */
static inline bool pel_texture_stride_fits(const struct pel_texture *p,
                                           int32_t bytes)
{
    const int32_t texels = p->stride / bytes;
    return texels >= -32768 && texels <= 32767;
}

/* Runs are inside whose texels and those `more` further right and down are;
 * with a mask any texel is. */
static PEL_ALWAYS_INLINE struct pel_texture_steps pel_texture_steps_make(
    const struct pel_texture *p, const struct pel_texture_writer *writer)
{
    const uint64_t du = p->map.u.dx, dv = p->map.v.dx;
    const uint32_t width = (uint32_t)p->width, height = (uint32_t)p->height;
    const uint32_t more = (uint32_t)writer->more;
    const bool all_u = !more && pel_texture_is_masked(p->width, p->wrap_u);
    const bool all_v = !more && pel_texture_is_masked(p->height, p->wrap_v);
    const uint32_t line = (uint32_t)(p->stride / writer->texel_bytes);
    const pel_u32x4 zero = {0, 0, 0, 0};
    return (struct pel_texture_steps){
        .du = du,
        .dv = dv,
        .u = {0, du},
        .v = {0, dv},
        .u_on = {2 * du, 2 * du},
        .v_on = {2 * dv, 2 * dv},
        .u_end = all_u ? UINT64_MAX : (uint64_t)(width - more) << 32,
        .v_end = all_v ? UINT64_MAX : (uint64_t)(height - more) << 32,
        .u_mask = zero + (all_u ? width - 1 : 0xFFFF),
        .v_mask = zero + (all_v ? height - 1 : 0xFFFF),
        .line = zero + (line & 0xFFFF),
        .stride = p->stride,
        .memory = p->memory,
        .set = p->kind == PEL_TEXTURE_XRGB8888 ? PEL_LE32(0xFF000000u) : 0};
}

/* Four pixels from the one at (u, v) on. */
static PEL_ALWAYS_INLINE struct pel_texture_four pel_texture_four_at(
    const struct pel_texture_steps *s, uint64_t u, uint64_t v)
{
    const pel_u64x2 a = u + s->u, b = v + s->v;
    return (struct pel_texture_four){{a, a + s->u_on}, {b, b + s->v_on}};
}

/* Of a run of 1 to 3 pixels: the first, the middle, and the last twice. */
static PEL_ALWAYS_INLINE struct pel_texture_four pel_texture_four_few(
    const struct pel_texture_steps *s, const struct pel_texture_run *r)
{
    const uint64_t half = (uint64_t)r->n >> 1;
    return (struct pel_texture_four){{(pel_u64x2){r->u, r->u + half * s->du},
                                      (pel_u64x2){r->u_last, r->u_last}},
                                     {(pel_u64x2){r->v, r->v + half * s->dv},
                                      (pel_u64x2){r->v_last, r->v_last}}};
}

/* Texels from texel (0, 0) to those of four pixels. Their masks keep u and v
 * below 65,536 and the upper halves 0, and in a picture they are below 32,767:
 * v's product with the stride's 16 bits fits 31. */
static PEL_ALWAYS_INLINE void pel_texture_four_index(
    const struct pel_texture_four *f, const struct pel_texture_steps *s,
    int32_t index[4])
{
    const pel_u32x4 u =
        PEL_LANES((pel_u32x4)f->u[0], (pel_u32x4)f->u[1], 1, 3, 5, 7);
    const pel_u32x4 v =
        PEL_LANES((pel_u32x4)f->v[0], (pel_u32x4)f->v[1], 1, 3, 5, 7);
    const pel_u64x2 i =
        (pel_u64x2)(pel_dot_s16(v & s->v_mask, s->line) + (u & s->u_mask));
    index[0] = (int32_t)i[0];
    index[1] = (int32_t)(i[0] >> 32);
    index[2] = (int32_t)i[1];
    index[3] = (int32_t)(i[1] >> 32);
}

static PEL_ALWAYS_INLINE void pel_texture_four_step(
    struct pel_texture_four *f, const struct pel_texture_steps *s)
{
    f->u[0] = f->u[1] + s->u_on;
    f->v[0] = f->v[1] + s->v_on;
    f->u[1] = f->u[0] + s->u_on;
    f->v[1] = f->v[0] + s->v_on;
}

/* The run of n pixels of which the first is at (u, v). */
static PEL_ALWAYS_INLINE struct pel_texture_run pel_texture_run_of(
    const struct pel_texture_steps *s, uint64_t u, uint64_t v, uintptr_t out,
    int32_t n)
{
    const uint64_t last = (uint64_t)n - 1;
    return (struct pel_texture_run){u,   v, u + last * s->du, v + last * s->dv,
                                    out, n};
}

/* A coordinate is affine, so a run is inside when both ends are. */
static PEL_ALWAYS_INLINE bool pel_texture_run_inside(
    const struct pel_texture_steps *s, const struct pel_texture_run *r)
{
    const uint64_t u = r->u > r->u_last ? r->u : r->u_last;
    const uint64_t v = r->v > r->v_last ? r->v : r->v_last;
    return u < s->u_end && v < s->v_end;
}

#endif
#endif
