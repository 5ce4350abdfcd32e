/* Smooth glyphs: coverage in sixteen steps, as runs. A font that `pel import
 * --bits 4` wrote names this kind, and is drawn and measured by the functions
 * of image/glyph_text.h and image/text_column.h in any paint, on any format
 * that can be blended.
 *
 * A glyph is a row of nibbles, the high half of a byte first, for its pixels
 * row by row: 1 to 14 is a pixel of so many fifteenths, 0 and 15 are followed
 * by the length of a run, as nibbles that add up, of which the last is not 15.
 * Runs go on from row to row. */
#ifndef PEL_IMAGE_SMOOTH_GLYPH_H
#define PEL_IMAGE_SMOOTH_GLYPH_H

#include "../asset/font_asset.h"
#include "../smooth/smooth.h"

PEL_BEGIN_DECLS

extern const struct pel_font_kind pel_font_smooth;

PEL_END_DECLS
#endif
