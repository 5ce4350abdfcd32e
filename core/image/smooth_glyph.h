/* Smooth glyphs: coverage in 4, 16 or 256 steps, as runs. A font that `pel
 * import --bits 2|4|8` wrote names its kind, and is drawn and measured by the
 * functions of image/glyph_text.h and image/text_column.h in any paint, on any
 * format that can be blended.
 *
 * A glyph is a row of steps of 2, 4 or 8 bits, the high ones of a byte first,
 * for its pixels row by row. 0 and the largest are followed by the length of a
 * run, as numbers of so many bits that add up, of which the last is not the
 * largest; each other step is a pixel. Runs go on from row to row. Where that
 * takes less, every step is a pixel: the glyph's offset has PEL_FONT_RAW. */
#ifndef PEL_IMAGE_SMOOTH_GLYPH_H
#define PEL_IMAGE_SMOOTH_GLYPH_H

#include "../asset/font_asset.h"
#include "../smooth/smooth.h"

PEL_BEGIN_DECLS

/* Of 4 bits, which is what fonts have unless somebody asks for others. */
extern const struct pel_font_kind pel_font_smooth;
extern const struct pel_font_kind pel_font_smooth_2, pel_font_smooth_8;

PEL_END_DECLS
#endif
