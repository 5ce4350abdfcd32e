#include "fast_texture.h"

#if PEL_FAST_FILLS && PEL_VECTORS

/* The bytes of two texels side by side, and of those below them by turns: of
 * four pixels. */
struct neighbours {
    pel_u8x16 of[4];
};

static PEL_ALWAYS_INLINE pel_u8x16 pair_at(const uint8_t *line, ptrdiff_t index)
{
    uint64_t pair;
    memcpy(&pair, line + 4 * index, 8);
    return (pel_u8x16)(pel_u64x2){pair, 0};
}

static PEL_ALWAYS_INLINE struct neighbours neighbours_32(const uint8_t *top,
                                                         const uint8_t *low,
                                                         const int32_t i[4])
{
    return (struct neighbours){
        {pel_zip_low_u8x16(pair_at(top, i[0]), pair_at(low, i[0])),
         pel_zip_low_u8x16(pair_at(top, i[1]), pair_at(low, i[1])),
         pel_zip_low_u8x16(pair_at(top, i[2]), pair_at(low, i[2])),
         pel_zip_low_u8x16(pair_at(top, i[3]), pair_at(low, i[3]))}};
}

static PEL_ALWAYS_INLINE uint32_t pair_565(const uint8_t *line, ptrdiff_t index)
{
    uint32_t pair;
    memcpy(&pair, line + 2 * index, 4);
    return pair;
}

/* The colors of eight texels of rgb565_le, as pel_texel: four and four. */
static PEL_ALWAYS_INLINE void colors_565(const uint8_t *line,
                                         const int32_t i[4],
                                         pel_u8x16 colors[2])
{
    const pel_u16x8 w =
        (pel_u16x8)(pel_u32x4){pair_565(line, i[0]), pair_565(line, i[1]),
                               pair_565(line, i[2]), pair_565(line, i[3])};
    const pel_u16x8 r = w >> 11, g = w & 0x07E0, b = w & 0x001F;
    const pel_u16x8 ra = r << 3 | r >> 2 | 0xFF00;
    const pel_u16x8 bg = g << 5 | (g >> 1 & 0x0300) | b << 3 | b >> 2;
    colors[0] =
        (pel_u8x16)PEL_SHUFFLE(pel_u16x8, bg, ra, 0, 8, 1, 9, 2, 10, 3, 11);
    colors[1] =
        (pel_u8x16)PEL_SHUFFLE(pel_u16x8, bg, ra, 4, 12, 5, 13, 6, 14, 7, 15);
}

static PEL_ALWAYS_INLINE struct neighbours neighbours_565(const uint8_t *top,
                                                          const uint8_t *low,
                                                          const int32_t i[4])
{
    pel_u8x16 ab[2], cd[2];
    colors_565(top, i, ab);
    colors_565(low, i, cd);
    return (struct neighbours){
        {pel_zip_low_u8x16(ab[0], cd[0]), pel_zip_high_u8x16(ab[0], cd[0]),
         pel_zip_low_u8x16(ab[1], cd[1]), pel_zip_high_u8x16(ab[1], cd[1])}};
}

/* a (256 - f) + b f in every lane: a in the lower half of a lane, b in the
 * upper one, the two weights likewise. The vector product is one of signed
 * numbers: they go from 2^15 below zero on. */
static PEL_ALWAYS_INLINE pel_u32x4 mix(pel_u32x4 ab, pel_u32x4 weights)
{
    return pel_dot_s16(ab ^ 0x80008000u, weights) + 32768 * 256;
}

/* A pixel's four channels from its texels a b over c d, by turns in `both`.
 * Down first: the exact sum is the same in any order, and it is rounded once.
 */
static PEL_ALWAYS_INLINE pel_u32x4 channels(pel_u8x16 both, pel_u32x4 wu,
                                            pel_u32x4 wv)
{
    const pel_u8x16 none = {0};
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

static PEL_ALWAYS_INLINE void put4(const struct pel_texture_steps *s, int bytes,
                                   const struct pel_texture_four *f,
                                   uintptr_t out)
{
    const pel_u32x4 u =
        PEL_LANES((pel_u32x4)f->u[0], (pel_u32x4)f->u[1], 0, 2, 4, 6);
    const pel_u32x4 v =
        PEL_LANES((pel_u32x4)f->v[0], (pel_u32x4)f->v[1], 0, 2, 4, 6);
    const pel_u32x4 wu = weights_of(u >> 24), wv = weights_of(v >> 24);
    const uint8_t *const top = s->memory, *const low = top + s->stride;
    int32_t i[4];
    pel_texture_four_index(f, s, i);
    const struct neighbours n =
        bytes == 2 ? neighbours_565(top, low, i) : neighbours_32(top, low, i);
    const pel_u32x4 a = channels(n.of[0], PEL_LANES(wu, wu, 0, 0, 0, 0),
                                 PEL_LANES(wv, wv, 0, 0, 0, 0));
    const pel_u32x4 b = channels(n.of[1], PEL_LANES(wu, wu, 1, 1, 1, 1),
                                 PEL_LANES(wv, wv, 1, 1, 1, 1));
    const pel_u32x4 c = channels(n.of[2], PEL_LANES(wu, wu, 2, 2, 2, 2),
                                 PEL_LANES(wv, wv, 2, 2, 2, 2));
    const pel_u32x4 d = channels(n.of[3], PEL_LANES(wu, wu, 3, 3, 3, 3),
                                 PEL_LANES(wv, wv, 3, 3, 3, 3));
    pel_put_u32x4((void *)out,
                  (pel_u32x4)pel_join_u8x16(pel_narrow_u16x8(a, b),
                                            pel_narrow_u16x8(c, d)) |
                      s->set);
}

#include "fast_texture_runs.inc"

static const struct pel_texture_writer from_565 = {2, 4, 1};
static const struct pel_texture_writer from_32 = {4, 4, 1};

static bool is_565(const struct pel_texture *p)
{
    return p->kind == PEL_TEXTURE_RGB565_LE;
}

/* Can vectors read the picture? */
static bool is_fit(const struct pel_texture *p)
{
    return p->kind < PEL_TEXTURE_BYTE &&
           pel_texture_stride_fits(p, is_565(p) ? 2 : 4);
}

static PEL_ALWAYS_INLINE void put_colors(
    const struct pel_texture *p, const struct pel_texture_axes *a, int32_t n,
    pel_color *out, const struct pel_texture_writer *writer)
{
    const struct pel_texture_steps s = pel_texture_steps_make(p, writer);
    const struct pel_texture_run r =
        pel_texture_run_of(&s, a->u, a->v, (uintptr_t)out, n);
    put_run(&s, &r, writer);
}

bool pel_texture_bilinear_run(const struct pel_texture *p,
                              const struct pel_texture_axes *a, int32_t n,
                              pel_color *out)
{
    if (!is_fit(p))
        return false;
    if (is_565(p))
        put_colors(p, a, n, out, &from_565);
    else
        put_colors(p, a, n, out, &from_32);
    return true;
}

bool pel_texture_bilinear_fast(const struct pel_texture *p,
                               const struct pel_spans *spans)
{
    const struct pel_surface *const s = spans->surface;
    if (!is_fit(p) || !pel_colors_in_place(&p->base, s))
        return false;
    if (is_565(p))
        fill_runs(p, s, spans, &from_565, pel_color_paint_fill);
    else
        fill_runs(p, s, spans, &from_32, pel_color_paint_fill);
    return true;
}

#endif
