#include "copy.h"

#include "copy_lines.h"

static void drop_key(pel_color *colors, int32_t n, uint32_t key)
{
    for (int32_t i = 0; i < n; i++)
        colors[i] =
            colors[i] << 8 == key << 8 ? 0 : colors[i] | PEL_RGB(0, 0, 0);
}

void pel_copy_keyed(const struct pel_surface *surface,
                    const struct pel_copy_part *copy, pel_color key)
{
    const struct pel_format *format = copy->source->format;
    if (!format || !surface->format || !format->load || !surface->format->put)
        pel_copy_lines(surface, copy, drop_key, key); /* copies nothing */
    else if (!pel_copy_same(surface, copy, &key))
        pel_copy_lines(surface, copy, drop_key,
                       format->unpack(format->pack(key)));
}
