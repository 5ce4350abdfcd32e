/* Icons: SVG files as assets for firmware, and drawn. */
#ifndef SIM_ICON_ICON_H
#define SIM_ICON_ICON_H

#include "core/asset/icon_asset.h"
#include "core/image/icon.h"
#include "sim/image/picture.h"

enum { ICON_SIZE_MAX = 4096 }; /* px of a picture */

/* Reads an SVG file in a child process. Its lists are malloc'ed. False, with a
 * message that says what it holds that pel does not draw, and in which line;
 * the icon is then empty. */
bool icon_load(struct pel_icon_asset *icon, const char *path);
void icon_free(struct pel_icon_asset *icon);

/* What draws all of it, smooth or not. */
const struct pel_icon_kind *icon_kind(const struct pel_icon_asset *icon,
                                      bool smooth);

/* What pel_icon needs at sizes from ICON_SCRATCH_SIZE_MIN to .._MAX px, at any
 * angle: sides in a row, and 1,024ths of its size that a row may be wide. Sides
 * are counted at some sizes, angles and places, and a quarter more is said: no
 * bound, but more than icons were found to need at random ones, a fifth more at
 * most. Smaller ones have all sides in a row, which may be twice as many. */
enum { ICON_SCRATCH_SIZE_MIN = 4, ICON_SCRATCH_SIZE_MAX = 256 };
struct icon_need {
    int32_t sides, width;
};
bool icon_need(struct icon_need *need, const struct pel_icon_asset *icon);

/* A picture whose longer side has `size` px, with alpha, smooth, as pel_icon
 * draws it. False, with a message. */
bool icon_picture(struct picture *picture, const struct pel_icon_asset *icon,
                  int size);

#endif
