#include "palette.h"

pel_color pel_palette_color(pel_color color)
{
    return color;
}

void pel_palette_load(const struct pel_surface *surface, int32_t x, int32_t y,
                      int32_t n, pel_color *colors)
{
    const struct pel_palette *palette = (const void *)surface->format;
    const uint8_t *line = pel_surface_line(surface, y);
    for (x -= surface->bounds.x0; n > 0; n--, x++)
        *colors++ = palette->colors[palette->format.bits == 8 ? line[x]
                                    : x & 1                   ? line[x / 2] & 15
                                            : line[x / 2] >> 4];
}
