#include "copy.h"

#include <string.h>

#include "copy_lines.h"

/* Are equal pixels equal bytes? Not where unused bits exist, which are written
 * as ones, and not where pixels share a byte. */
static bool bytes_alike(const struct pel_format *a, const struct pel_format *b)
{
    return a->id == b->id && a->bits >= 8 && a->pack(0) == 0;
}

static void copy_bytes(const struct pel_surface *surface,
                       const struct pel_copy_part *copy,
                       const struct pel_rect *r)
{
    const struct pel_surface *source = copy->source;
    const int32_t dx = copy->x - copy->area.x0, dy = copy->y - copy->area.y0;
    const int32_t bytes = surface->format->bits / 8;
    const int32_t to = (r->x0 - surface->bounds.x0) * bytes;
    const int32_t from = (r->x0 - dx - source->bounds.x0) * bytes;
    const size_t size = (size_t)(r->x1 - r->x0) * (size_t)bytes;
    for (int32_t y = r->y0; y < r->y1; y++)
        memcpy(pel_surface_line(surface, y) + to,
               pel_surface_line(source, y - dy) + from, size);
}

static void make_opaque(pel_color *colors, int32_t n, uint32_t option)
{
    (void)option;
    for (int32_t i = 0; i < n; i++)
        colors[i] |= PEL_RGB(0, 0, 0);
}

void pel_copy(const struct pel_surface *surface,
              const struct pel_copy_part *copy)
{
    struct pel_rect r;
    if (!bytes_alike(surface->format, copy->source->format))
        pel_copy_lines(surface, copy, make_opaque, 0);
    else if (pel_copy_visible(surface, copy, &r))
        copy_bytes(surface, copy, &r);
}
