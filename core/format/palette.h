/* Pictures of 4 or 8 bits a pixel, each an index of a color: sources of copies
 * and textures, into which nothing can be drawn. `pel import --format palette8`
 * writes both parts:
 *
 *     pel_image_asset_surface(&picture, &logo, &logo_palette.format);
 *
 * A palette is a format of its own, so a picture may have several. */
#ifndef PEL_FORMAT_PALETTE_H
#define PEL_FORMAT_PALETTE_H

#include "../base/surface.h"

PEL_BEGIN_DECLS

struct pel_palette {
    struct pel_format format;
    const pel_color *colors; /* 16 or 256, with alpha */
};

/* An initialiser; bits is 4 or 8. */
#define PEL_PALETTE(bits, colors)                                 \
    {                                                             \
        {(bits) == 4 ? PEL_FORMAT_PALETTE4 : PEL_FORMAT_PALETTE8, \
         (bits),                                                  \
         1,                                                       \
         {0, 0, 0},                                               \
         pel_palette_color,                                       \
         pel_palette_color,                                       \
         NULL,                                                    \
         NULL,                                                    \
         NULL,                                                    \
         pel_palette_load,                                        \
         NULL},                                                   \
            (colors)                                              \
    }

/* pack and unpack: a color, such as a key's, is its own pixel value. */
pel_color pel_palette_color(pel_color color);

void pel_palette_load(const struct pel_surface *surface, int32_t x, int32_t y,
                      int32_t n, pel_color *colors);
PEL_END_DECLS
#endif
