/* Text of a font of outlines: any size and any angle from one table. Letters of
 * one size that stand upright take less time from a font of pictures
 * (image/glyph_text.h).
 *
 *     const struct pel_point hub = {PEL_PX(120), PEL_PX(120)};
 *     struct pel_outline_text_block label = {
 *         .font = &dejavu, .string = "80", .align = PEL_TEXT_CENTER};
 *     label.transform = pel_outline_transform(
 *         &dejavu, PEL_PX(18), PEL_DEGREES(45),
 *         pel_polar(hub, PEL_PX(90), PEL_DEGREES(-45)));
 *     pel_smooth_outline_text(&screen, &label, &white.paint, scratch,
 *                             sizeof scratch);
 */
#ifndef PEL_IMAGE_OUTLINE_TEXT_H
#define PEL_IMAGE_OUTLINE_TEXT_H

#include "../asset/outline_font_asset.h"
#include "../base/trig.h"
#include "../path/path.h"
#include "text_column.h"

PEL_BEGIN_DECLS

struct pel_outline_text_block {
    const struct pel_outline_font_asset *font; /* checked */
    const char *string;             /* UTF-8, ends with a 0; up to 2^14 bytes */
    struct pel_transform transform; /* of the font's units; its `at` is where
                                       the first baseline begins, has its middle
                                       or ends, as `align` says */
    enum pel_text_align align;
    int32_t tolerance; /* as in struct pel_path_shape */
};

/* Places a font whose em is `size` (1/256 px, 0..32,767 px) high, turned
 * clockwise by `turn` about `at`. */
struct pel_transform pel_outline_transform(
    const struct pel_outline_font_asset *font, int32_t size, int32_t turn,
    struct pel_point at);

/* Fills the glyphs of the text by the rule non-zero, each as pel_path_fill does
 * its outline: a shape of its own. The pen and line feeds are those of pel_text
 * in units of the font; where its place is rounded to 1/256 px the glyph's
 * points are rounded from there, and the middle of two controls is that of the
 * rounded ones, rounded down. A glyph is walked only where the font's box
 * around it meets the clip. Scratch memory is that of pel_path_fill; errors
 * too, of the first glyph that has one, and the text ends there. A glyph whose
 * pen is out of range is left out. */
enum pel_status pel_outline_text(const struct pel_surface *surface,
                                 const struct pel_outline_text_block *text,
                                 const struct pel_paint *paint, void *scratch,
                                 size_t size);

/* Is the pixel covered by one of them? */
bool pel_hit_outline_text(const struct pel_outline_text_block *text, int32_t x,
                          int32_t y);

/* How far the pen moves on the first line of a string, in units of the font. */
int32_t pel_outline_text_width(const struct pel_outline_font_asset *font,
                               const char *string);
PEL_END_DECLS
#endif
