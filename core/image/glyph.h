/* 1-bit pictures, drawn with any paint. */
#ifndef PEL_IMAGE_GLYPH_H
#define PEL_IMAGE_GLYPH_H

#include "../raster/paint.h"

PEL_BEGIN_DECLS

struct pel_stencil {
    const uint8_t *bits; /* rows from the top, the left pixel in the high bit */
    int32_t stride;      /* bytes from a row to the next, at least width / 8 */
    int32_t width, height; /* px, 0..32,767 */
};

/* Paints the pixels whose bit is set, each once, with the glyph's left top
 * pixel at (x, y). x and y lie in -65,536..65,536 px: otherwise nothing is
 * drawn, which is a broken contract (PEL_ASSERT). */
void pel_glyph(const struct pel_surface *surface,
               const struct pel_stencil *glyph, int32_t x, int32_t y,
               const struct pel_paint *paint);
PEL_END_DECLS
#endif
