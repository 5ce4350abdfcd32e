/* The exact area of strokes in pixels, by sub-scanlines with exact x. */
#ifndef TESTS_SUPPORT_STROKE_AREA_H
#define TESTS_SUPPORT_STROKE_AREA_H

#include "core/pel.h"

enum { STROKE_AREA_SIZE = 24 };

/* What a stroke covers of each pixel of STROKE_AREA_SIZE x STROKE_AREA_SIZE
 * from (x0, y0) on, 0 to 1, by so many scanlines a row. False: a miter is so
 * near its limit that numbers of double precision do not tell. At most 64
 * points. */
bool stroke_area(const struct pel_polyline_shape *line, int32_t x0, int32_t y0,
                 int scanlines,
                 double area[STROKE_AREA_SIZE][STROKE_AREA_SIZE]);

/* A polyline, for cases_keep. */
void stroke_print(const void *line);

#endif
