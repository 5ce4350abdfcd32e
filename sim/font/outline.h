/* Outlines of FreeType as smooth pictures, by the exact areas of core/smooth,
 * or as points. */
#ifndef SIM_FONT_OUTLINE_H
#define SIM_FONT_OUTLINE_H

#include <ft2build.h>
#include FT_OUTLINE_H

#include "sim/font/points.h"

/* Coverage of an outline in 1/64 px, a byte a pixel, malloc'ed; width, height,
 * left and top of `c` are set. NULL, with a message, when memory is short; of
 * an outline that is too large or empty width and height say so, and the result
 * is empty, too. */
uint8_t *outline_draw(FT_Outline *outline, struct font_char *c);

/* The points of an outline in 1/64 of the font's units, whose parts may begin
 * at another point then. Where two quadratic curves meet half-way between their
 * controls, and where parts close, points are left out. */
void outline_put(FT_Outline *outline, struct font_points *points);

#endif
