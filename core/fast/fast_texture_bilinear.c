#include "fast_texture.h"

#if PEL_FAST_FILLS && PEL_VECTORS

/* The colours of two texels of rgb565_le, the second in the upper half: as
 * pel_texel, both at a time. */
static inline uint64_t pair_of_565(uint64_t a, uint64_t b)
{
    const uint64_t both = UINT64_C(0x100000001), w = a | b << 32;
    const uint64_t c = (w & 0xF800 * both) << 8 | (w & 0x07E0 * both) << 5 |
                       (w & 0x001F * both) << 3;
    return c | (c >> 5 & 0x070007 * both) | (c >> 6 & 0x000300 * both) |
           0xFF000000 * both;
}

/* Two texels side by side. */
static PEL_ALWAYS_INLINE uint64_t pair_at(const uint8_t *line, int kind,
                                          ptrdiff_t index)
{
    uint64_t pair;
    if (kind == PEL_TEXTURE_RGB565_LE) {
        const pel_word16 *w = (const pel_word16 *)(const void *)line + index;
        return pair_of_565(w[0], w[1]);
    }
    memcpy(&pair, line + 4 * index, 8);
    return pair;
}

/* a (256 - f) + b f in every lane: a in the lower half of a lane, b in the
 * upper one, the two weights likewise. The vector product is one of signed
 * numbers: they go from 2^15 below zero on. */
static PEL_ALWAYS_INLINE pel_u32x4 mix(pel_u32x4 ab, pel_u32x4 weights)
{
    return pel_dot_s16(ab ^ 0x80008000u, weights) + 32768 * 256;
}

/* A pixel's four channels from its texels a b over c d. Down first: the exact
 * sum is the same in any order, and it is rounded once. */
static PEL_ALWAYS_INLINE pel_u32x4 channels(uint64_t ab, uint64_t cd,
                                            pel_u32x4 wu, pel_u32x4 wv)
{
    const pel_u8x16 none = {0};
    const pel_u8x16 both = pel_zip_low_u8x16((pel_u8x16)(pel_u64x2){ab, 0},
                                             (pel_u8x16)(pel_u64x2){cd, 0});
    /* Below 256, so that signed products do. */
    const pel_u32x4 ac =
        pel_dot_s16((pel_u32x4)pel_zip_low_u8x16(both, none), wv);
    const pel_u32x4 bd =
        pel_dot_s16((pel_u32x4)pel_zip_high_u8x16(both, none), wv);
    return (mix(ac | bd << 16, wu) + 32768) >> 16;
}

/* 256 - f and f from numbers f below 256. */
static PEL_ALWAYS_INLINE pel_u32x4 weights_of(pel_u32x4 f)
{
    return (f << 16) - f + 256;
}

static PEL_ALWAYS_INLINE pel_u32x4 mixed(const struct pel_texture_steps *s,
                                         int kind,
                                         const struct pel_texture_four *f)
{
    const pel_u32x4 u =
        PEL_LANES((pel_u32x4)f->u[0], (pel_u32x4)f->u[1], 0, 2, 4, 6);
    const pel_u32x4 v =
        PEL_LANES((pel_u32x4)f->v[0], (pel_u32x4)f->v[1], 0, 2, 4, 6);
    const pel_u32x4 wu = weights_of(u >> 24), wv = weights_of(v >> 24);
    const uint8_t *const top = s->memory, *const low = top + s->stride;
    int32_t i[4];
    pel_texture_four_index(f, &s->lanes, false, i);
    const pel_u32x4 a =
        channels(pair_at(top, kind, i[0]), pair_at(low, kind, i[0]),
                 PEL_LANES(wu, wu, 0, 0, 0, 0), PEL_LANES(wv, wv, 0, 0, 0, 0));
    const pel_u32x4 b =
        channels(pair_at(top, kind, i[1]), pair_at(low, kind, i[1]),
                 PEL_LANES(wu, wu, 1, 1, 1, 1), PEL_LANES(wv, wv, 1, 1, 1, 1));
    const pel_u32x4 c =
        channels(pair_at(top, kind, i[2]), pair_at(low, kind, i[2]),
                 PEL_LANES(wu, wu, 2, 2, 2, 2), PEL_LANES(wv, wv, 2, 2, 2, 2));
    const pel_u32x4 d =
        channels(pair_at(top, kind, i[3]), pair_at(low, kind, i[3]),
                 PEL_LANES(wu, wu, 3, 3, 3, 3), PEL_LANES(wv, wv, 3, 3, 3, 3));
    return (pel_u32x4)pel_narrow_u8x16(a, b, c, d) | s->set;
}

/* The last four pixels come first and overlap those before them. */
static PEL_ALWAYS_INLINE void put_run(const struct pel_texture_steps *steps,
                                      int kind, const struct pel_texture_run *r)
{
    /* Pixels may alias what is not local: this stays in registers. */
    const struct pel_texture_steps copy = *steps, *const s = &copy;
    pel_word32 *out = (pel_word32 *)r->out;
    const uint64_t last = (uint64_t)r->n - 4;
    struct pel_texture_two t = pel_texture_two_at(
        &s->lanes, r->u + last * s->lanes.du, r->v + last * s->lanes.dv);
    struct pel_texture_four f = r->n < 4 ? pel_texture_four_few(&s->lanes, r)
                                         : pel_texture_four_next(&t, &s->lanes);
    const pel_u32x4 pixels = mixed(s, kind, &f);
    if (r->n < 4) {
        out[0] = pixels[0];
        out[r->n >> 1] = pixels[1];
        out[r->n - 1] = pixels[2];
        return;
    }
    pel_word32 *const end = out + last;
    pel_put_u32x4(end, pixels);
    t = pel_texture_two_at(&s->lanes, r->u, r->v);
    for (; out < end; out += 4) {
        f = pel_texture_four_next(&t, &s->lanes);
        pel_put_u32x4(out, mixed(s, kind, &f));
    }
}

static PEL_NOINLINE void put_run_32(const struct pel_texture_steps *s,
                                    const struct pel_texture_run *r)
{
    put_run(s, PEL_TEXTURE_COLORS, r);
}

static PEL_NOINLINE void put_run_565(const struct pel_texture_steps *s,
                                     const struct pel_texture_run *r)
{
    put_run(s, PEL_TEXTURE_RGB565_LE, r);
}

static int32_t bytes_of(const struct pel_texture *p)
{
    return p->kind == PEL_TEXTURE_RGB565_LE ? 2 : 4;
}

static bool is_fit(const struct pel_texture *p)
{
    return p->kind < PEL_TEXTURE_BYTE &&
           pel_texture_stride_fits(p, bytes_of(p));
}

bool pel_texture_bilinear_run(const struct pel_texture *p,
                              const struct pel_texture_axes *a, int32_t n,
                              pel_color *out)
{
    if (!is_fit(p))
        return false;
    const struct pel_texture_steps s =
        pel_texture_steps_make(p, bytes_of(p), 1, false);
    const struct pel_texture_run r = {(uintptr_t)out, a->u.at, a->v.at, n};
    if (bytes_of(p) == 2)
        put_run_565(&s, &r);
    else
        put_run_32(&s, &r);
    return true;
}

bool pel_texture_bilinear_fast(const struct pel_paint *paint,
                               const struct pel_surface *surface,
                               const struct pel_fast_triangle *triangle)
{
    const struct pel_texture *p = (const void *)paint;
    if (!p->base.opaque || surface->format->id != PEL_FORMAT_XRGB8888 ||
        !is_fit(p))
        return false;
    const int32_t bytes = bytes_of(p);
    const struct pel_texture_steps s =
        pel_texture_steps_make(p, bytes, 1, false);
    struct pel_texture_walk w = pel_texture_walk_begin(p, surface, triangle, 4);
    struct pel_texture_run r;
    w.u -= PEL_TEXTURE_HALF_BACK;
    w.v -= PEL_TEXTURE_HALF_BACK;
    for (int32_t x; pel_texture_walk_next(&w, &p->map, 4, &x, &r);) {
        if (r.n <= 0)
            continue;
        if (!pel_texture_run_inside(&r, &s))
            pel_texture_fill_run(p, surface, x, r.n, w.rows.y - 1);
        else if (bytes == 2)
            put_run_565(&s, &r);
        else
            put_run_32(&s, &r);
    }
    return true;
}

#endif
