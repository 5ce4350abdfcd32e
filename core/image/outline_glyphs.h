/* The seam between text of outlines and what fills the sides of a glyph. */
#ifndef PEL_IMAGE_OUTLINE_GLYPHS_H
#define PEL_IMAGE_OUTLINE_GLYPHS_H

#include "../path/sides.h"
#include "outline_text.h"

typedef enum pel_status pel_sides_filler(
    const struct pel_surface *surface, const struct pel_outline_source *source,
    enum pel_fill_rule rule, const struct pel_paint *paint,
    const struct pel_scratch *scratch);

/* How glyphs are filled. */
struct pel_outline_fill {
    pel_sides_filler *fill;
    const struct pel_paint *paint;
    struct pel_scratch scratch;
};

enum pel_status pel_outline_text_fill(const struct pel_surface *surface,
                                      const struct pel_outline_text_block *text,
                                      const struct pel_outline_fill *fill);

#endif
