/* Runs of textures by vectors, four pixels at a time. */
#ifndef PEL_FAST_FAST_TEXTURE_H
#define PEL_FAST_FAST_TEXTURE_H

#include "../format/vector.h"
#include "../paint/paint_texture_fetch.h"

#if PEL_FAST_FILLS && PEL_VECTORS

/* A run of n > 0 pixels, and where the first is in the picture. */
struct pel_texture_run {
    uintptr_t out;
    uint64_t u, v;
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

/* A way to write runs. */
struct pel_texture_writer {
    void (*put)(const struct pel_texture_steps *steps,
                const struct pel_texture_run *run);
    int32_t texel_bytes, pixel_bytes;
    int32_t more; /* 1: it reads the texels further right and down, too;
                     0: it repeats the picture where a mask does */
};

struct pel_texture_steps pel_texture_steps_make(
    const struct pel_texture *p, const struct pel_texture_writer *writer);

/* Fills spans by `writer`, and those that leave the picture by `other`, in the
 * pixels of `surface`. */
void pel_texture_fill_runs(const struct pel_texture *p,
                           const struct pel_surface *surface,
                           const struct pel_spans *spans,
                           const struct pel_texture_writer *writer,
                           pel_texture_fill *other);

/* Do lines lie as many texels apart as fit the 16 bits of vectors? So they do
 * but in a part of a very wide picture. */
static inline bool pel_texture_stride_fits(const struct pel_texture *p,
                                           int32_t bytes)
{
    const int32_t texels = p->stride / bytes;
    return texels >= -32768 && texels <= 32767;
}

/* Both coordinates of four pixels. */
struct pel_texture_four {
    pel_u64x2 u[2], v[2];
};

/* The four pixels from the k-th of a run on. */
static PEL_ALWAYS_INLINE struct pel_texture_four pel_texture_four_at(
    const struct pel_texture_steps *s, const struct pel_texture_run *r,
    uint64_t k)
{
    const pel_u64x2 u = r->u + k * s->du + s->u, v = r->v + k * s->dv + s->v;
    return (struct pel_texture_four){{u, u + s->u_on}, {v, v + s->v_on}};
}

/* Of a run of 1 to 3 pixels: the first, the middle, and the last twice. */
static PEL_ALWAYS_INLINE struct pel_texture_four pel_texture_four_few(
    const struct pel_texture_steps *s, const struct pel_texture_run *r)
{
    const uint64_t half = (uint64_t)r->n >> 1, last = (uint64_t)r->n - 1;
    const uint64_t u = r->u + last * s->du, v = r->v + last * s->dv;
    return (struct pel_texture_four){
        {(pel_u64x2){r->u, r->u + half * s->du}, (pel_u64x2){u, u}},
        {(pel_u64x2){r->v, r->v + half * s->dv}, (pel_u64x2){v, v}}};
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

/* Stores the pixels of four texels; `kind` tells the ways of a writer apart. */
typedef void pel_texture_put4(const struct pel_texture_steps *steps, int kind,
                              const struct pel_texture_four *four,
                              uintptr_t out);

/* A writer's `put`, inlined with constant `bytes` of a pixel and `kind`. The
 * last four pixels come first and overlap those before them. */
static PEL_ALWAYS_INLINE void pel_texture_put_run(
    const struct pel_texture_steps *steps, const struct pel_texture_run *r,
    int bytes, int kind, pel_texture_put4 *put4)
{
    /* Pixels may alias what is not local: this stays in registers. */
    const struct pel_texture_steps copy = *steps, *const s = &copy;
    const uintptr_t size = (uintptr_t)bytes, n = (uintptr_t)r->n;
    struct pel_texture_four f;
    if (n < 4) {
        uint32_t words[4];
        const uint8_t *const four = (const uint8_t *)words;
        f = pel_texture_four_few(s, r);
        put4(s, kind, &f, (uintptr_t)words);
        memcpy((void *)r->out, four, size);
        memcpy((void *)(r->out + n / 2 * size), four + size, size);
        memcpy((void *)(r->out + (n - 1) * size), four + 2 * size, size);
        return;
    }
    uintptr_t out = r->out;
    const uintptr_t end = out + (n - 4) * size;
    f = pel_texture_four_at(s, r, n - 4);
    put4(s, kind, &f, end);
    f = pel_texture_four_at(s, r, 0);
    for (; out < end; out += 4 * size) {
        put4(s, kind, &f, out);
        f.u[0] = f.u[1] + s->u_on;
        f.v[0] = f.v[1] + s->v_on;
        f.u[1] = f.u[0] + s->u_on;
        f.v[1] = f.v[0] + s->v_on;
    }
}

#endif
#endif
