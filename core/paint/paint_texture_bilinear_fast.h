/* Bilinear textures on 64-bit CPUs with vectors: the same bytes as
 * paint_texture_bilinear.c, four pixels at a time. */
#ifndef PEL_PAINT_PAINT_TEXTURE_BILINEAR_FAST_H
#define PEL_PAINT_PAINT_TEXTURE_BILINEAR_FAST_H

#include "paint_texture_fetch.h"

/* Half a texel back to the middle of the texel before, and half of 1/256 on so
 * that weights are rounded. */
enum { PEL_TEXTURE_HALF_BACK = 0x80000000u - 0x800000u };

#if PEL_FAST_64BIT && PEL_VECTORS

/* The colors of a span that lies inside the picture with the texels right of it
 * and below; false for other spans, and pictures that do not fit vectors. */
bool pel_texture_bilinear_run(const struct pel_texture *p,
                              const struct pel_texture_axes *a, int32_t n,
                              pel_color *out);

bool pel_texture_bilinear_fast(const struct pel_paint *paint,
                               const struct pel_surface *surface,
                               const struct pel_fast_triangle *triangle);

#else

#define pel_texture_bilinear_run(p, a, n, out) false

#endif
#endif
