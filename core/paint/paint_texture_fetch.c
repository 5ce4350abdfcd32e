#include "paint_texture_fetch.h"

static enum pel_texture_kind kind_of(const struct pel_format *format)
{
    if (format->id == PEL_FORMAT_ARGB8888 && PEL_LE32(UINT32_C(1)) == 1)
        return PEL_TEXTURE_COLORS;
    if (format->id == PEL_FORMAT_XRGB8888)
        return PEL_TEXTURE_XRGB8888;
    if (format->id == PEL_FORMAT_RGB565_LE)
        return PEL_TEXTURE_RGB565_LE;
    if (!PEL_SMALL_CODE && format->bits == 8 && format->id < PEL_FORMAT_MONO1)
        return PEL_TEXTURE_BYTE;
    return PEL_TEXTURE_ANY;
}

static enum pel_status set_surface(struct pel_texture *p,
                                   const struct pel_surface *s)
{
    if (!s->format || !s->format->load)
        return PEL_ERROR_FORMAT;
    p->width = s->bounds.x1 - s->bounds.x0;
    p->height = s->bounds.y1 - s->bounds.y0;
    p->memory = s->pixels;
    p->stride = s->stride;
    p->kind = (uint8_t)kind_of(s->format);
    p->base.opaque = s->format->id < PEL_FORMAT_ARGB8888 ||
                     s->format->id > PEL_FORMAT_PALETTE8;
    return PEL_OK;
}

static enum pel_status set_colors(struct pel_texture *p,
                                  const struct pel_texels *t)
{
    if (!t->colors)
        return PEL_ERROR_NULL;
    if (t->width < 1 || t->width > 32767 || t->height < 1 || t->height > 32767)
        return PEL_ERROR_SIZE;
    p->width = t->width;
    p->height = t->height;
    p->memory = (const uint8_t *)t->colors;
    p->stride = t->width * (int32_t)sizeof(pel_color);
    p->kind = PEL_TEXTURE_COLORS;
    p->base.opaque = t->opaque;
    return PEL_OK;
}

/* One by one: less code than a call of memcpy. */
static PEL_NOINLINE_32 void copy_plane(struct pel_plane *to,
                                       const struct pel_plane *from)
{
    to->at = from->at;
    to->dx = from->dx;
    to->dy = from->dy;
}

enum pel_status pel_texture_set(struct pel_texture *paint,
                                const struct pel_texels *texels,
                                const struct pel_texture_map *map)
{
    if (paint)
        pel_paint_clear(&paint->base.paint);
    if (!paint || !texels || !map)
        return PEL_ERROR_NULL;
    copy_plane(&paint->map.u, &map->u);
    copy_plane(&paint->map.v, &map->v);
    paint->surface = texels->surface;
    paint->wrap_u = PEL_WRAP_CLAMP;
    paint->wrap_v = PEL_WRAP_CLAMP;
    return texels->surface ? set_surface(paint, texels->surface)
                           : set_colors(paint, texels);
}
