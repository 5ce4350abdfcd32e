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

static inline const void *pel_texture_line(const struct pel_texture *p,
                                           int32_t v)
{
    return p->memory + (ptrdiff_t)v * p->stride;
}

static PEL_SHARED pel_color pel_texel_of_565(uint32_t w)
{
    return PEL_RGB(pel_widen(w >> 11, 5), pel_widen(w >> 5 & 63, 6),
                   pel_widen(w & 31, 5));
}

static PEL_HOT pel_color pel_texel(const struct pel_texture *p, int kind,
                                   int32_t u, int32_t v)
{
    const void *line = pel_texture_line(p, v);
    if (kind == PEL_TEXTURE_COLORS)
        return ((const pel_word32 *)line)[u];
    if (kind == PEL_TEXTURE_XRGB8888)
        return PEL_LE32(((const pel_word32 *)line)[u]) | UINT32_C(0xFF000000);
    if (kind == PEL_TEXTURE_RGB565_LE)
        return pel_texel_of_565(PEL_LE16(((const pel_word16 *)line)[u]));
    if (!PEL_SMALL_CODE && kind == PEL_TEXTURE_BYTE)
        return p->surface->format->unpack(((const uint8_t *)line)[u]);
    pel_color color;
    p->surface->format->load(p->surface, u + p->surface->bounds.x0,
                             v + p->surface->bounds.y0, 1, &color);
    return color;
}

/* The coordinate at pixel (x, y). */
static inline uint64_t pel_texture_at(const struct pel_plane *p, int32_t x,
                                      int32_t y)
{
    return p->at + pel_times(p->dx, x) + pel_times(p->dy, y);
}

/* One coordinate along a run, in 2^-32 texels. `period` is after how many
 * texels the picture begins again; 0 with PEL_WRAP_CLAMP: it does not. */
struct pel_texture_axis {
    uint64_t at;
    int32_t size, period;
};

static inline void pel_texture_axis_wrap(struct pel_texture_axis *a,
                                         int32_t size, int wrap)
{
    a->size = size;
    a->period = wrap == PEL_WRAP_CLAMP ? 0 : size;
    if (wrap == PEL_WRAP_MIRROR)
        a->period *= 2;
}

/* Sizes that are powers of two repeat by a mask, which is size - 1. */
static inline bool pel_texture_is_masked(int32_t size, int wrap)
{
    return wrap == PEL_WRAP_REPEAT && (size & (size - 1)) == 0;
}

/* Are texel(s) `at` to `at + more` of all n pixels inside the picture? */
static inline bool pel_texture_axis_inside(const struct pel_texture_axis *a,
                                           uint64_t step, int32_t n,
                                           int32_t more)
{
    uint64_t last = a->at + pel_times(step, n - 1);
    uint32_t inner = (uint32_t)(a->size - more);
    return (uint32_t)(a->at >> 32) < inner && (uint32_t)(last >> 32) < inner;
}

/* The whole texels of the coordinate, brought back into one period by a floored
 * modulo, but for PEL_WRAP_CLAMP. */
static PEL_SHARED int32_t pel_texture_axis_index(struct pel_texture_axis *a)
{
    int32_t i = (int32_t)(a->at >> 32);
    if ((uint32_t)i < (uint32_t)a->period || a->period == 0)
        return i;
    pel_floor_divide(i, a->period, &i);
    a->at = (uint64_t)(uint32_t)i << 32 | (a->at & 0xFFFFFFFFu);
    return i;
}

/* The texel of index i, or the one that stands for it; without PEL_WRAP_CLAMP i
 * is from 0 to the period. */
static PEL_SHARED int32_t
pel_texture_axis_texel(const struct pel_texture_axis *a, int32_t i)
{
    if ((uint32_t)i < (uint32_t)a->size)
        return i;
    if (a->period == 0)
        return i < 0 ? 0 : a->size - 1;
    return i == a->period ? 0 : 2 * a->size - 1 - i;
}

/* Both coordinates. */
struct pel_texture_axes {
    struct pel_texture_axis u, v;
};

/* From pixel (x, y) on, less `back`. */
static inline void pel_texture_axes_start(struct pel_texture_axes *a,
                                          const struct pel_texture *p,
                                          int32_t x, int32_t y, uint32_t back)
{
    a->u.at = pel_texture_at(&p->map.u, x, y) - back;
    a->v.at = pel_texture_at(&p->map.v, x, y) - back;
    pel_texture_axis_wrap(&a->u, p->width, p->wrap_u);
    pel_texture_axis_wrap(&a->v, p->height, p->wrap_v);
}

/* One pixel to the right. */
static inline void pel_texture_axes_step(struct pel_texture_axes *a,
                                         const struct pel_texture *p)
{
    a->u.at += p->map.u.dx;
    a->v.at += p->map.v.dx;
}

/* Are texels `at` to `at + more` of n pixels inside the picture, both ways? */
static inline bool pel_texture_axes_inside(const struct pel_texture_axes *a,
                                           const struct pel_texture *p,
                                           int32_t n, int32_t more)
{
    return pel_texture_axis_inside(&a->u, p->map.u.dx, n, more) &&
           pel_texture_axis_inside(&a->v, p->map.v.dx, n, more);
}

/* A run by a function that is inlined: each kind has a loop of its own. */
static PEL_ALWAYS_INLINE void pel_texture_run(
    const struct pel_texture *p, const struct pel_texture_axes *a, int32_t n,
    pel_color *out,
    void (*run)(const struct pel_texture *p, int kind,
                const struct pel_texture_axes *a, int32_t n, pel_color *out))
{
    if (p->kind == PEL_TEXTURE_COLORS)
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
