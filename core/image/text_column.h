/* Text in a column: lines broken at spaces, aligned, at any distance. */
#ifndef PEL_IMAGE_TEXT_COLUMN_H
#define PEL_IMAGE_TEXT_COLUMN_H

#include "glyph_text.h"

PEL_BEGIN_DECLS

enum pel_text_align { PEL_TEXT_LEFT, PEL_TEXT_CENTER, PEL_TEXT_RIGHT };

struct pel_text_column {
    struct pel_text_block text; /* x, y: top left corner of the column */
    int32_t width;              /* px of the column, 0..65,536. 0: lines end
                                   at line feeds alone, and x is where they
                                   begin, have their middle, or end */
    int32_t line_height; /* px from line to line, -255..255, upwards below 0;
                            0: as the font's */
    enum pel_text_align align;
};

/* Paints the text as pel_text does, and returns the size of its lines. A line
 * takes as many words as fit the column; the spaces between it and the next are
 * left out, as are those before a line feed or the end if they do not fit; a
 * word wider than the column is cut. surface NULL: only the size. x, y, width
 * or line_height out of range is a broken contract: PEL_ASSERT, and nothing is
 * drawn; the size is then 0. For strings up to 2^22 bytes. */
struct pel_text_size pel_text_column_draw(const struct pel_surface *surface,
                                          const struct pel_text_column *column,
                                          const struct pel_paint *paint);
PEL_END_DECLS
#endif
