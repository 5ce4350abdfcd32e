#include "../format/word16.h"
#include "paint_texture_fetch.h"

/* The texel where the axis is, or the one that stands for it. */
static inline int32_t in_picture(struct pel_texture_axis *a)
{
    return pel_texture_axis_texel(a, pel_texture_axis_index(a));
}

static void outer_run(const struct pel_texture *p, struct pel_texture_axes *a,
                      int32_t n, pel_color *out)
{
    for (; n > 0; n--, pel_texture_axes_step(a)) {
        int32_t u = in_picture(&a->u), v = in_picture(&a->v);
        *out++ = pel_texel(p, p->kind, u, v);
    }
}

#if PEL_FAST_64BIT

/* A run that does not leave the picture. */
static PEL_ALWAYS_INLINE void inner_run(const struct pel_texture *p, int kind,
                                        const struct pel_texture_axes *a,
                                        int32_t n, pel_color *out)
{
    const uint64_t du = a->u.step, dv = a->v.step;
    uint64_t u = a->u.at, v = a->v.at;
    for (; n > 0; n--, u += du, v += dv)
        *out++ = pel_texel(p, kind, (int32_t)(u >> 32), (int32_t)(v >> 32));
}

/* A run of a kind that is read without a call. */
static void fast_run(const struct pel_texture *p,
                     const struct pel_texture_axes *a, int32_t n,
                     pel_color *out)
{
    if (p->kind == PEL_TEXTURE_COLORS)
        inner_run(p, PEL_TEXTURE_COLORS, a, n, out);
    else if (p->kind == PEL_TEXTURE_XRGB8888)
        inner_run(p, PEL_TEXTURE_XRGB8888, a, n, out);
    else
        inner_run(p, PEL_TEXTURE_RGB565_LE, a, n, out);
}

#endif

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_texture *p = (const void *)paint;
    struct pel_texture_axes a;
    pel_texture_axes_start(&a, p, x, y, 0);
#if PEL_FAST_64BIT
    if (p->kind != PEL_TEXTURE_ANY && pel_texture_axes_inside(&a, n, 0)) {
        fast_run(p, &a, n, out);
        return;
    }
#endif
    outer_run(p, &a, n, out);
}

/* Everything that the loop needs is in registers of a Cortex-M. */
static void copy_inner_run(const struct pel_texture *p,
                           const struct pel_texture_axes *a, int32_t n,
                           pel_word16 *out)
{
    const uint8_t *const memory = p->memory;
    const int32_t stride = p->stride;
    const uint64_t du = a->u.step, dv = a->v.step;
    uint64_t u = a->u.at, v = a->v.at;
    for (const pel_word16 *end = out + n; out != end; u += du, v += dv) {
        const void *line = memory + (int32_t)(v >> 32) * (ptrdiff_t)stride;
        *out++ = ((const pel_word16 *)line)[(int32_t)(u >> 32)];
    }
}

static void copy_run(const struct pel_texture *p, struct pel_texture_axes *a,
                     int32_t n, pel_word16 *out)
{
    if (pel_texture_axes_inside(a, n, 0)) {
        copy_inner_run(p, a, n, out);
        return;
    }
    for (; n > 0; n--, pel_texture_axes_step(a)) {
        int32_t u = in_picture(&a->u), v = in_picture(&a->v);
        const void *line = p->memory + v * (ptrdiff_t)p->stride;
        *out++ = ((const pel_word16 *)line)[u];
    }
}

/* Pixels of 16 bits that are all colour. */
static bool is_565(const struct pel_format *format)
{
    return format->id == PEL_FORMAT_RGB565_LE ||
           format->id == PEL_FORMAT_RGB565_BE ||
           format->id == PEL_FORMAT_BGR565_LE;
}

/* From such a surface to another of its format. */
static bool copy(const struct pel_color_paint *paint,
                 const struct pel_rows *rows)
{
    const struct pel_texture *p = (const void *)paint;
    const struct pel_surface *s = rows->surface;
    const struct pel_row *row = rows->row;
    struct pel_texture_axes a;
    if (!p->surface || p->surface->format != s->format || !is_565(s->format))
        return false;
    for (int32_t i = 0, y = rows->y; i < rows->n; i++, row++, y += rows->step)
        if (row->x0 < row->x1) {
            pel_texture_axes_start(&a, p, row->x0, y, 0);
            copy_run(p, &a, row->x1 - row->x0, pel_address16(s, row->x0, y));
        }
    return true;
}

enum pel_status pel_texture_init_nearest(struct pel_texture *paint,
                                         const struct pel_texels *texels,
                                         const struct pel_texture_map *map)
{
    enum pel_status status = pel_texture_set(paint, texels, map);
    if (status != PEL_OK)
        return status;
    pel_color_paint_init(&paint->base, colors, paint->base.opaque);
    paint->base.direct = copy;
    return PEL_OK;
}
