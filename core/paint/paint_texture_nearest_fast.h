/* Nearest textures on 64-bit CPUs: the row loop of a triangle whose texels are
 * copied as they are. */
#ifndef PEL_PAINT_PAINT_TEXTURE_NEAREST_FAST_H
#define PEL_PAINT_PAINT_TEXTURE_NEAREST_FAST_H

#include "paint_texture_fetch.h"

/* Between surfaces of one 565 format, pixels of 16 bits that are all colour,
 * texels are copied. */
static inline bool pel_texture_is_copied(const struct pel_texture *p,
                                         const struct pel_format *format)
{
    return p->surface && p->surface->format == format &&
           (format->id == PEL_FORMAT_RGB565_LE ||
            format->id == PEL_FORMAT_RGB565_BE ||
            format->id == PEL_FORMAT_BGR565_LE);
}

bool pel_texture_nearest_fast(const struct pel_paint *paint,
                              const struct pel_surface *surface,
                              const struct pel_fast_triangle *triangle);

#endif
