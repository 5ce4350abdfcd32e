/* Fonts as assets in memory (core/asset/font_asset.h). */
#ifndef SIM_FONT_ASSET_H
#define SIM_FONT_ASSET_H

#include "core/asset/font_asset.h"
#include "sim/font/font.h"

/* Makes the asset of a font: glyphs in the order of their code points, equal
 * bits once. Its arrays are malloc'ed; the font is not needed any more. False,
 * with a message that names `path`, when it has too many glyphs or memory is
 * short; the asset is then empty. */
bool font_asset_make(struct pel_font_asset *asset, const struct font *font,
                     const char *path);

/* Gives a font without a glyph for what it lacks (missing, U+FFFD or `?`) a box
 * for that. False when memory is short. */
bool font_add_box(struct font *font);

/* The font of pel's own texts, 6x13, Latin-1. False, with a message, when
 * memory is short. */
bool font_asset_builtin(struct pel_font_asset *asset);

void font_asset_free(struct pel_font_asset *asset);

/* For assets of either kind: the index of a character's glyph among the first
 * 256, or -1; ranges of the characters, and how many they are, at most one for
 * each; the glyph of the font's character for others, of U+FFFD, or of `?`, or
 * PEL_FONT_NONE. False, with a message, for too many glyphs. */
int font_index_of(const struct font *font, uint32_t code);
uint16_t font_fill_ranges(struct pel_font_range *range,
                          const struct font *font);
uint16_t font_missing_of(const struct font *font);
bool font_count_legal(const struct font *font, const char *path);

#endif
