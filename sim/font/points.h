/* Outlines of glyphs as points, as core/asset/outline_font_asset.h has them. */
#ifndef SIM_FONT_POINTS_H
#define SIM_FONT_POINTS_H

#include "sim/font/font.h"

/* The points of an outline on their way into bytes. */
struct font_points {
    uint8_t *bytes; /* malloc'ed */
    size_t size;
    int x, y;            /* of the last point */
    int box[4];          /* left, bottom, right, top of all points; all 0 at
                            first */
    bool failed, beyond; /* memory is short; a coordinate is out of range */
};

/* Adds a point, `kind` of enum pel_outline_point. */
void font_points_add(struct font_points *points, int kind, int x, int y);

/* Adds a glyph of these points to a font of outlines; `glyph` has its code
 * and its advance. False, with a message, when memory is short. */
bool font_points_keep(struct font *font, const struct font_char *glyph,
                      const struct font_points *points);

#endif
