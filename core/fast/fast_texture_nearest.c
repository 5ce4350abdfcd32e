#include "fast_texture.h"

#if PEL_FAST_FILLS && PEL_VECTORS

/* Texels as they are, but for bits that are set. */
static PEL_ALWAYS_INLINE void put4(const struct pel_texture_steps *s, int bytes,
                                   const struct pel_texture_four *f,
                                   uintptr_t out)
{
    const pel_word16 *const half = (const void *)s->memory;
    const pel_word32 *const word = (const void *)s->memory;
    pel_word16 *const p = (pel_word16 *)out;
    int32_t i[4];
    pel_texture_four_index(f, s, i);
    if (bytes == 4) {
        const pel_u32x4 pixels = {word[i[0]], word[i[1]], word[i[2]],
                                  word[i[3]]};
        pel_put_u32x4(p, pixels | s->set);
        return;
    }
    p[0] = half[i[0]];
    p[1] = half[i[1]];
    p[2] = half[i[2]];
    p[3] = half[i[3]];
}

#include "fast_texture_runs.inc"

/* Are texels, but for bits that are set, pixels of xrgb8888? */
static bool is_32(const struct pel_texture *p, const struct pel_format *format)
{
    return format->id == PEL_FORMAT_XRGB8888 && p->base.opaque &&
           (p->kind == PEL_TEXTURE_XRGB8888 || p->kind == PEL_TEXTURE_COLORS);
}

bool pel_texture_nearest_fast(const struct pel_texture *p,
                              const struct pel_spans *spans,
                              pel_texture_fill *other)
{
    static const struct pel_texture_writer narrow = {2, 2, 0};
    static const struct pel_texture_writer wide = {4, 4, 0};
    const struct pel_surface *const s = spans->surface;
    const struct pel_surface *const to = pel_texture_copied_to(p, s);
    if (!pel_texture_stride_fits(p, to ? 2 : 4))
        return false;
    if (to)
        fill_runs(p, to, spans, &narrow, other);
    else if (is_32(p, s->format))
        fill_runs(p, s, spans, &wide, other);
    else
        return false;
    return true;
}

#endif
