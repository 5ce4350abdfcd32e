#include "../format/word.h"
#include "fast_texture.h"

#if PEL_FAST_FILLS

/* Texels are copied as they are, `bytes` wide, but for bits that are set. */
static PEL_ALWAYS_INLINE uint32_t texel_at(const uint8_t *memory, int bytes,
                                           ptrdiff_t index)
{
    return bytes == 2 ? ((const pel_word16 *)(const void *)memory)[index]
                      : ((const pel_word32 *)(const void *)memory)[index];
}

static PEL_ALWAYS_INLINE void put(uintptr_t out, int bytes, uint32_t pixel)
{
    if (bytes == 2)
        *(pel_word16 *)out = (pel_word16)pixel;
    else
        *(pel_word32 *)out = pixel;
}

/* The pixel of a texel; `masked`: see pel_texture_four_index. */
static PEL_ALWAYS_INLINE uint32_t pixel_at(const struct pel_texture_steps *s,
                                           int bytes, bool masked, uint64_t u,
                                           uint64_t v)
{
    uint32_t i = (uint32_t)(u >> 32), j = (uint32_t)(v >> 32);
    if (masked) {
        i &= s->u_mask;
        j &= s->v_mask;
    }
    return texel_at(s->memory + (ptrdiff_t)j * s->stride, bytes, i) | s->set;
}

#if PEL_VECTORS

/* `masked`: see pel_texture_four_index. */
static PEL_ALWAYS_INLINE void put4(const struct pel_texture_steps *s, int bytes,
                                   bool masked, uintptr_t out,
                                   const struct pel_texture_four *f)
{
    int32_t i[4];
    pel_texture_four_index(f, &s->lanes, masked, i);
    if (bytes == 4) {
        const pel_u32x4 a = {texel_at(s->memory, 4, i[0])},
                        b = {texel_at(s->memory, 4, i[1])},
                        c = {texel_at(s->memory, 4, i[2])},
                        d = {texel_at(s->memory, 4, i[3])};
        const pel_u32x4 ab = PEL_LANES(a, b, 0, 4, 1, 5);
        const pel_u32x4 cd = PEL_LANES(c, d, 0, 4, 1, 5);
        pel_put_u32x4((void *)out, PEL_LANES(ab, cd, 0, 1, 4, 5) | s->set);
        return;
    }
    put(out, 2, texel_at(s->memory, 2, i[0]));
    put(out + 2, 2, texel_at(s->memory, 2, i[1]));
    put(out + 4, 2, texel_at(s->memory, 2, i[2]));
    put(out + 6, 2, texel_at(s->memory, 2, i[3]));
}

/* Fewer than 4 pixels: the first, the middle and the last one. */
static PEL_ALWAYS_INLINE void put_few(const struct pel_texture_steps *s,
                                      int bytes, bool masked,
                                      const struct pel_texture_run *r)
{
    const uint64_t du = s->lanes.du, dv = s->lanes.dv;
    const uint64_t half = (uint64_t)r->n >> 1, last = (uint64_t)r->n - 1;
    put(r->out, bytes, pixel_at(s, bytes, masked, r->u, r->v));
    put(r->out + half * (uintptr_t)bytes, bytes,
        pixel_at(s, bytes, masked, r->u + half * du, r->v + half * dv));
    put(r->out + last * (uintptr_t)bytes, bytes,
        pixel_at(s, bytes, masked, r->u + last * du, r->v + last * dv));
}

/* The last four pixels come first and overlap those before them. */
static PEL_ALWAYS_INLINE void put_run(const struct pel_texture_steps *s,
                                      int bytes, bool masked,
                                      const struct pel_texture_run *r)
{
    if (r->n < 4) {
        put_few(s, bytes, masked, r);
        return;
    }
    const uint64_t last = (uint64_t)r->n - 4;
    const uintptr_t end = r->out + last * (uintptr_t)bytes;
    struct pel_texture_two t = pel_texture_two_at(
        &s->lanes, r->u + last * s->lanes.du, r->v + last * s->lanes.dv);
    struct pel_texture_four f = pel_texture_four_next(&t, &s->lanes);
    put4(s, bytes, masked, end, &f);
    t = pel_texture_two_at(&s->lanes, r->u, r->v);
    for (uintptr_t out = r->out; out < end; out += 4 * (uintptr_t)bytes) {
        f = pel_texture_four_next(&t, &s->lanes);
        put4(s, bytes, masked, out, &f);
    }
}

#else

static PEL_ALWAYS_INLINE void put_run(const struct pel_texture_steps *s,
                                      int bytes, bool masked,
                                      const struct pel_texture_run *r)
{
    uint64_t u = r->u, v = r->v;
    uintptr_t out = r->out;
    for (int32_t n = r->n; n > 0; n--, u += s->lanes.du, v += s->lanes.dv) {
        put(out, bytes, pixel_at(s, bytes, masked, u, v));
        out += (uintptr_t)bytes;
    }
}

#endif

static PEL_ALWAYS_INLINE void put_rows_masked(const struct pel_texture *p,
                                              const struct pel_surface *surface,
                                              const struct pel_fast_triangle *t,
                                              int bytes, bool masked)
{
    const struct pel_texture_steps s =
        pel_texture_steps_make(p, bytes, 0, masked);
    const struct pel_texture_map map = p->map;
    struct pel_texture_walk w = pel_texture_walk_begin(p, surface, t, bytes);
    struct pel_texture_run r;
    for (int32_t x; pel_texture_walk_next(&w, &map, bytes, &x, &r);) {
        if (r.n <= 0)
            continue;
        if (pel_texture_run_inside(&r, &s))
            put_run(&s, bytes, masked, &r);
        else
            pel_texture_fill_run(p, surface, x, r.n, w.rows.y - 1);
    }
}

/* Without a mask a loop has two registers more, which gcc needs. */
static PEL_ALWAYS_INLINE void put_rows(const struct pel_texture *p,
                                       const struct pel_surface *surface,
                                       const struct pel_fast_triangle *t,
                                       int bytes)
{
    if (pel_texture_is_masked(p->width, p->wrap_u) ||
        pel_texture_is_masked(p->height, p->wrap_v))
        put_rows_masked(p, surface, t, bytes, true);
    else
        put_rows_masked(p, surface, t, bytes, false);
}

/* Are texels, but for bits that are set, pixels of xrgb8888? */
static bool is_32(const struct pel_texture *p, const struct pel_format *format)
{
    return format->id == PEL_FORMAT_XRGB8888 && p->base.opaque &&
           (p->kind == PEL_TEXTURE_XRGB8888 ||
            (p->kind == PEL_TEXTURE_COLORS && PEL_LE32(UINT32_C(1)) == 1));
}

bool pel_texture_nearest_fast(const struct pel_paint *paint,
                              const struct pel_surface *surface,
                              const struct pel_fast_triangle *triangle)
{
    const struct pel_texture *p = (const void *)paint;
    const struct pel_format *format = surface->format;
    if (pel_texture_is_copied(p, format) && pel_texture_stride_fits(p, 2))
        put_rows(p, surface, triangle, 2);
    else if (is_32(p, format) && pel_texture_stride_fits(p, 4))
        put_rows(p, surface, triangle, 4);
    else
        return false;
    return true;
}

#endif
