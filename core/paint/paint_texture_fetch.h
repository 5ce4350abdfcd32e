/* Texels by their place: what nearest and bilinear textures share. */
#ifndef PEL_PAINT_PAINT_TEXTURE_FETCH_H
#define PEL_PAINT_PAINT_TEXTURE_FETCH_H

#include "../format/word.h"
#include "../raster/edge.h"
#include "paint_texture.h"

/* How texels are read: the first three without a call, those of a byte by
 * unpack, all others by load. */
enum pel_texture_kind {
    PEL_TEXTURE_COLORS,
    PEL_TEXTURE_XRGB8888,
    PEL_TEXTURE_RGB565_LE,
    PEL_TEXTURE_BYTE,
    PEL_TEXTURE_ANY
};

/* Sets all but the functions of the paint. */
enum pel_status pel_texture_set(struct pel_texture *paint,
                                const struct pel_texels *texels,
                                const struct pel_texture_map *map);

static PEL_SHARED pel_color pel_texel_of_565(uint32_t w)
{
    return PEL_RGB(pel_widen(w >> 11, 5), pel_widen(w >> 5 & 63, 6),
                   pel_widen(w & 31, 5));
}

/* By the format. */
static PEL_STEP PEL_UNUSED pel_color
pel_texel_loaded(const struct pel_texture *p, int32_t u, int32_t v)
{
    const struct pel_surface *const s = p->surface;
    pel_color color;
    s->format->load(s, u + s->bounds.x0, v + s->bounds.y0, 1, &color);
    return color;
}

static PEL_HOT pel_color pel_texel(const struct pel_texture *p, int kind,
                                   int32_t u, int32_t v)
{
    const void *line = p->memory + (ptrdiff_t)v * p->stride;
    if (kind == PEL_TEXTURE_COLORS)
        return ((const pel_word32 *)line)[u];
    if (kind == PEL_TEXTURE_XRGB8888)
        return PEL_LE32(((const pel_word32 *)line)[u]) | UINT32_C(0xFF000000);
    if (kind == PEL_TEXTURE_RGB565_LE)
        return pel_texel_of_565(PEL_LE16(((const pel_word16 *)line)[u]));
    if (!PEL_SMALL_CODE && kind == PEL_TEXTURE_BYTE)
        return p->surface->format->unpack(((const uint8_t *)line)[u]);
    return pel_texel_loaded(p, u, v);
}

/* One side of a picture. `period` is after how many texels it begins again; 0
 * with PEL_WRAP_CLAMP: it does not. */
struct pel_texture_side {
    int32_t size, period;
};

static inline struct pel_texture_side pel_texture_side_of(int32_t size,
                                                          int wrap)
{
    const struct pel_texture_side side = {size, wrap == PEL_WRAP_CLAMP ? 0
                                                : wrap == PEL_WRAP_MIRROR
                                                    ? 2 * size
                                                    : size};
    return side;
}

/* Sizes that are powers of two repeat by a mask, which is size - 1. */
static inline bool pel_texture_is_masked(int32_t size, int wrap)
{
    return wrap == PEL_WRAP_REPEAT && (size & (size - 1)) == 0;
}

/* The whole texels of a coordinate, brought back into one period by a floored
 * modulo, but for PEL_WRAP_CLAMP. */
static PEL_STEP PEL_UNUSED int32_t pel_texture_wrap(uint64_t *at,
                                                    int32_t period)
{
    int32_t i;
    pel_floor_divide((int32_t)(*at >> 32), period, &i);
    *at = (uint64_t)(uint32_t)i << 32 | (*at & 0xFFFFFFFFu);
    return i;
}

static PEL_SHARED int32_t pel_texture_index(uint64_t *at, int32_t period)
{
    const int32_t i = (int32_t)(*at >> 32);
    return (uint32_t)i < (uint32_t)period || period == 0
               ? i
               : pel_texture_wrap(at, period);
}

/* The texel of index i, or the one that stands for it; without PEL_WRAP_CLAMP i
 * is from 0 to the period. */
static PEL_SHARED int32_t pel_texture_texel(struct pel_texture_side s,
                                            int32_t i)
{
    if ((uint32_t)i < (uint32_t)s.size)
        return i;
    if (s.period == 0)
        return i < 0 ? 0 : s.size - 1;
    return i == s.period ? 0 : 2 * s.size - 1 - i;
}

/* Both coordinates along a run, in 2^-32 texels. */
struct pel_texture_axes {
    uint64_t u, v;
};

/* At pixel (x, y). */
static PEL_STEP PEL_UNUSED void pel_texture_start(uint64_t *at,
                                                  const struct pel_plane *p,
                                                  int32_t x, int32_t y)
{
    *at = p->at;
    *at += pel_times(p->dx, x);
    *at += pel_times(p->dy, y);
}

/* From pixel (x, y) on. */
static PEL_ALWAYS_INLINE void pel_texture_axes_start(
    struct pel_texture_axes *a, const struct pel_texture *p, int32_t x,
    int32_t y)
{
    pel_texture_start(&a->u, &p->map.u, x, y);
    pel_texture_start(&a->v, &p->map.v, x, y);
}

/* One pixel to the right. */
static PEL_ALWAYS_INLINE void pel_texture_axes_step(struct pel_texture_axes *a,
                                                    const struct pel_texture *p)
{
    a->u += p->map.u.dx;
    a->v += p->map.v.dx;
}

/* Is the first texel of each of n pixels one of the first `inner` ones? */
static PEL_STEP PEL_UNUSED bool pel_texture_inside(const uint64_t *at,
                                                   const struct pel_plane *p,
                                                   int32_t n, int32_t inner)
{
    if ((uint32_t)(*at >> 32) >= (uint32_t)inner)
        return false;
    const uint64_t last = *at + pel_times(p->dx, n - 1);
    return (uint32_t)(last >> 32) < (uint32_t)inner;
}

/* Are texels `at` to `at + more` of n pixels inside the picture, both ways? */
static PEL_ALWAYS_INLINE bool pel_texture_axes_inside(
    const struct pel_texture_axes *a, const struct pel_texture *p, int32_t n,
    int32_t more)
{
    return pel_texture_inside(&a->u, &p->map.u, n, p->width - more) &&
           pel_texture_inside(&a->v, &p->map.v, n, p->height - more);
}

/* Is there a loop for a run inside the picture? Calls in it take stack. */
static inline bool pel_texture_has_run(const struct pel_texture *p)
{
    return !PEL_SMALL_CODE && (!PEL_SHORT_STACK || p->kind < PEL_TEXTURE_BYTE);
}

/* A run by a function that is inlined: each kind has a loop of its own. */
static PEL_ALWAYS_INLINE void pel_texture_run(
    const struct pel_texture *p, struct pel_texture_axes *a, int32_t n,
    pel_color *out,
    void (*run)(const struct pel_texture *p, int kind,
                struct pel_texture_axes *a, int32_t n, pel_color *out))
{
    if (PEL_SHORT_STACK && PEL_FEW_REGISTERS)
        run(p, p->kind, a, n, out);
    else if (p->kind == PEL_TEXTURE_COLORS)
        run(p, PEL_TEXTURE_COLORS, a, n, out);
    else if (p->kind == PEL_TEXTURE_XRGB8888)
        run(p, PEL_TEXTURE_XRGB8888, a, n, out);
    else if (p->kind == PEL_TEXTURE_RGB565_LE)
        run(p, PEL_TEXTURE_RGB565_LE, a, n, out);
    else
        run(p, p->kind, a, n, out);
}

/* Between surfaces of one 565 format, pixels of 16 bits that are all color,
 * texels are copied: the surface that gets them, or NULL. */
static inline const struct pel_surface *pel_texture_copied_to(
    const struct pel_texture *p, const struct pel_surface *s)
{
    if (!PEL_SMALL_CODE && s->format->channels && s->format->channels->target)
        s = s->format->channels->target(s);
    return p->surface && p->surface->format == s->format &&
                   (s->format->id == PEL_FORMAT_RGB565_LE ||
                    s->format->id == PEL_FORMAT_RGB565_BE ||
                    s->format->id == PEL_FORMAT_BGR565_LE)
               ? s
               : NULL;
}

/* Bilinear: half a texel back to the middle of the texel before, and half of
 * 1/256 on so that weights are rounded. */
enum { PEL_TEXTURE_HALF_BACK = 0x80000000u - 0x800000u };

/* A paint's fill. */
typedef void pel_texture_fill(const struct pel_paint *paint,
                              const struct pel_spans *spans);

/* In core/fast: the same bytes, four pixels at a time. False, and nothing is
 * done, where the picture or the format is not for vectors. */

/* Nearest, of texels that are copied as they are; `other` fills spans that
 * leave the picture. */
bool pel_texture_nearest_fast(const struct pel_texture *p,
                              const struct pel_spans *spans,
                              pel_texture_fill *other);

bool pel_texture_bilinear_fast(const struct pel_texture *p,
                               const struct pel_spans *spans);

/* The colors of a run that lies inside the picture with the texels right of it
 * and below. */
bool pel_texture_bilinear_run(const struct pel_texture *p,
                              const struct pel_texture_axes *a, int32_t n,
                              pel_color *out);

#endif
