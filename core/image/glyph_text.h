/* 1-bit pictures, drawn with any paint; text: glyphs of a font next to each
 * other, of one bit or smooth. */
#ifndef PEL_IMAGE_GLYPH_TEXT_H
#define PEL_IMAGE_GLYPH_TEXT_H

#include "../asset/font_asset.h"
#include "../raster/paint.h"

PEL_BEGIN_DECLS

struct pel_stencil {
    const uint8_t *bits; /* rows from the top, the left pixel in the high bit */
    int32_t stride; /* bytes from row to row: those of the width, or more */
    int32_t width, height; /* px, 0..32,767 */
};

/* Paints the pixels whose bit is set, each once, with the glyph's top left
 * pixel at (x, y). x and y lie in -65,536..65,536 px: otherwise nothing is
 * drawn, which is a broken contract (PEL_ASSERT). */
void pel_glyph(const struct pel_surface *surface,
               const struct pel_stencil *glyph, int32_t x, int32_t y,
               const struct pel_paint *paint);

struct pel_text_block {
    const struct pel_font_asset *font; /* pel_font_asset_check gave PEL_OK */
    const char *string;                /* UTF-8, ends with a 0 */
    int32_t x, y; /* px, -65,536..65,536: left end and top of the first line */
};

struct pel_text_size {
    int32_t width, height; /* px */
};

/* pel_text of what comes before `end`, the address of a character of the text,
 * or NULL: all. */
void pel_text_until(const struct pel_surface *surface,
                    const struct pel_text_block *text, const char *end,
                    const struct pel_paint *paint);

/* Paints the text. Glyphs stand in boxes `advance` wide, closer or further
 * apart by the font's pairs, and ascent + descent high; the pen starts at x
 * with the baseline `ascent` below y. A line feed goes back to x and down by a
 * line. A character that the font lacks is taken from the next font of its
 * chain that has it, on the same baseline; where none has, the font shows its
 * `missing` glyph. Combining marks have an advance of 0 and stand on the
 * character before them. Letters are not joined, and text is not reordered for
 * scripts that are written from right to left.
 * Each glyph is a shape of its own: where two overlap, which takes a font whose
 * glyphs reach beyond their boxes, both are painted. x or y out of range is a
 * broken contract: PEL_ASSERT, and nothing is drawn. For strings up to 2^22
 * bytes. */
static inline void pel_text(const struct pel_surface *surface,
                            const struct pel_text_block *text,
                            const struct pel_paint *paint)
{
    pel_text_until(surface, text, NULL, paint);
}

/* The same with a square of scale x scale px for each pixel; scale is 1 to
 * 1,024. All fonts of the chain have one bit a pixel: smooth ones are imported
 * at the size that is wanted. The text is `scale` times as large as
 * pel_text_measure says. */
void pel_text_scaled(const struct pel_surface *surface,
                     const struct pel_text_block *text, int32_t scale,
                     const struct pel_paint *paint);

/* The size of all boxes: as wide as the widest line, as high as all lines, one
 * more than there are line feeds. For strings up to 2^22 bytes. */
struct pel_text_size pel_text_measure(const struct pel_font_asset *font,
                                      const char *string);

/* The code point at *text, which ends with a 0; moves *text behind it. Bytes
 * that are not UTF-8 (stray and missing bytes, overlong forms, surrogates, more
 * than U+10FFFF) give U+FFFD once for every sequence that breaks off. */
uint32_t pel_utf8_next(const char **text);

/* What the font's pairs move the pen between two glyphs, px: 0 where the left
 * one is another font's; either may be NULL. */
static inline int32_t pel_glyph_kerning(const struct pel_font_asset *font,
                                        const struct pel_font_glyph *left,
                                        const struct pel_font_glyph *right)
{
    return font->kind && left && right ? font->kind->kerning(font, left, right)
                                       : 0;
}

/* The glyph of a code point in the first of a chain of fonts that has it, which
 * *font becomes; else the `missing` one of *font, or NULL. */
const struct pel_font_glyph *pel_glyph_find(const struct pel_font_asset **font,
                                            uint32_t code);

/* The number of characters of a text that no font of the chain has. */
uint32_t pel_text_missing(const struct pel_font_asset *font,
                          const char *string);
PEL_END_DECLS
#endif
