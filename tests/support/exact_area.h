/* The exact area of polygons in pixels, to 2^-40 px^2. */
#ifndef TESTS_SUPPORT_EXACT_AREA_H
#define TESTS_SUPPORT_EXACT_AREA_H

#include "core/pel.h"

/* The area inside a closed outline of n vertices, which does not cross itself;
 * *edges is how many edges cross the pixel. */
long double exact_area(const struct pel_point *v, int32_t n, int32_t x,
                       int32_t y, int *edges);

/* The area inside a polygon of at most 16 vertices, which may cross itself;
 * *pieces is how many pieces of edges, between their ends and crossings, the
 * pixel holds. */
long double exact_polygon_area(const struct pel_polygon_shape *p, int32_t x,
                               int32_t y, int *pieces);

#endif
