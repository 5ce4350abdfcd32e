/* Characters and their glyphs. */
#ifndef PEL_IMAGE_GLYPH_FIND_H
#define PEL_IMAGE_GLYPH_FIND_H

#include "../asset/font_asset.h"

/* The code point at *text, which ends with a 0, and moves *text behind it. What
 * is no UTF-8 (stray and missing bytes, overlong forms, surrogates, more than
 * U+10FFFF) gives U+FFFD once for every byte sequence that cannot go on. */
uint32_t pel_utf8_next(const char **text);

/* The glyph of a code point; the font's `missing` one when it has none of its
 * own; NULL when it lacks that too. */
const struct pel_font_glyph *pel_glyph_find(const struct pel_font_asset *font,
                                            uint32_t code);

#endif
