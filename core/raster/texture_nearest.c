#include "../format/word16.h"
#include "texture_fetch.h"

static void start(const struct pel_texture *p, int32_t x, int32_t y,
                  struct pel_texture_axis *u, struct pel_texture_axis *v)
{
    pel_texture_axis_start(u, &p->map.u, x, y);
    pel_texture_axis_start(v, &p->map.v, x, y);
    pel_texture_axis_wrap(u, p->width, p->wrap_u);
    pel_texture_axis_wrap(v, p->height, p->wrap_v);
}

static bool inside(const struct pel_texture_axis *u,
                   const struct pel_texture_axis *v, int32_t n)
{
    return pel_texture_axis_inside(u, n, 0) && pel_texture_axis_inside(v, n, 0);
}

static void outer_run(const struct pel_texture *p, struct pel_texture_axis *u,
                      struct pel_texture_axis *v, int32_t n, pel_color *out)
{
    for (; n > 0; n--, u->at += u->step, v->at += v->step) {
        int32_t i = pel_texture_axis_index(u), j = pel_texture_axis_index(v);
        *out++ = pel_texel(p, p->kind, pel_texture_axis_texel(u, i),
                           pel_texture_axis_texel(v, j));
    }
}

#if PEL_FAST_64BIT

/* A run that does not leave the picture. */
static PEL_ALWAYS_INLINE void inner_run(const struct pel_texture *p, int kind,
                                        const struct pel_texture_axis *along_u,
                                        const struct pel_texture_axis *along_v,
                                        int32_t n, pel_color *out)
{
    uint64_t u = along_u->at, v = along_v->at;
    for (; n > 0; n--, u += along_u->step, v += along_v->step)
        *out++ = pel_texel(p, kind, (int32_t)(u >> 32), (int32_t)(v >> 32));
}

/* A run of a kind that is read without a call. */
static void fast_run(const struct pel_texture *p,
                     const struct pel_texture_axis *u,
                     const struct pel_texture_axis *v, int32_t n,
                     pel_color *out)
{
    if (p->kind == PEL_TEXTURE_COLORS)
        inner_run(p, PEL_TEXTURE_COLORS, u, v, n, out);
    else if (p->kind == PEL_TEXTURE_XRGB8888)
        inner_run(p, PEL_TEXTURE_XRGB8888, u, v, n, out);
    else
        inner_run(p, PEL_TEXTURE_RGB565_LE, u, v, n, out);
}

#endif

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_texture *p = (const void *)paint;
    struct pel_texture_axis u, v;
    start(p, x, y, &u, &v);
#if PEL_FAST_64BIT
    if (p->kind != PEL_TEXTURE_ANY && inside(&u, &v, n)) {
        fast_run(p, &u, &v, n, out);
        return;
    }
#endif
    outer_run(p, &u, &v, n, out);
}

/* Everything that the loop needs is in registers of a Cortex-M. */
static void copy_inner_run(const struct pel_texture *p,
                           const struct pel_texture_axis *along_u,
                           const struct pel_texture_axis *along_v, int32_t n,
                           pel_word16 *out)
{
    const uint8_t *const memory = p->memory;
    const int32_t stride = p->stride;
    const uint64_t du = along_u->step, dv = along_v->step;
    uint64_t u = along_u->at, v = along_v->at;
    for (const pel_word16 *end = out + n; out != end; u += du, v += dv) {
        const void *line = memory + (int32_t)(v >> 32) * (ptrdiff_t)stride;
        *out++ = ((const pel_word16 *)line)[(int32_t)(u >> 32)];
    }
}

static void copy_run(const struct pel_texture *p, struct pel_texture_axis *u,
                     struct pel_texture_axis *v, int32_t n, pel_word16 *out)
{
    if (inside(u, v, n)) {
        copy_inner_run(p, u, v, n, out);
        return;
    }
    for (; n > 0; n--, u->at += u->step, v->at += v->step) {
        int32_t i = pel_texture_axis_index(u), j = pel_texture_axis_index(v);
        int32_t column = pel_texture_axis_texel(u, i);
        const void *line =
            p->memory + pel_texture_axis_texel(v, j) * (ptrdiff_t)p->stride;
        *out++ = ((const pel_word16 *)line)[column];
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
    struct pel_texture_axis u, v;
    if (!p->surface || p->surface->format != s->format || !is_565(s->format))
        return false;
    for (int32_t i = 0, y = rows->y; i < rows->n; i++, row++, y += rows->step)
        if (row->x0 < row->x1) {
            start(p, row->x0, y, &u, &v);
            copy_run(p, &u, &v, row->x1 - row->x0,
                     pel_address16(s, row->x0, y));
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
