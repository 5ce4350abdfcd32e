/* Fonts of outlines as assets in memory (core/asset/outline_font_asset.h). */
#ifndef SIM_FONT_OUTLINE_ASSET_H
#define SIM_FONT_OUTLINE_ASSET_H

#include "core/asset/outline_font_asset.h"
#include "sim/font/font.h"

/* As font_asset_make and its neighbours, of a font with an em. */
bool outline_asset_make(struct pel_outline_font_asset *asset,
                        const struct font *font, const char *path);
bool outline_add_box(struct font *font);
void outline_asset_free(struct pel_outline_font_asset *asset);

#endif
