/* Text of a font of outlines with smooth edges. */
#ifndef PEL_IMAGE_SMOOTH_OUTLINE_TEXT_H
#define PEL_IMAGE_SMOOTH_OUTLINE_TEXT_H

#include "../path/smooth_path.h"
#include "outline_text.h"

PEL_BEGIN_DECLS

/* As pel_outline_text, with glyphs as pel_smooth_path_fill draws them. Of the
 * scratch memory the row of pixels is no wider than a glyph's box. */
enum pel_status pel_smooth_outline_text(
    const struct pel_surface *surface,
    const struct pel_outline_text_block *text, const struct pel_paint *paint,
    void *scratch, size_t size);
PEL_END_DECLS
#endif
