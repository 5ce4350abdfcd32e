/* A paint that compares every row of a triangle with 128-bit arithmetic, in the
 * moment it is handed the row. No pixel memory is needed, so the surface may be
 * as large as surfaces are. */
#ifndef TESTS_SUPPORT_PROBE_H
#define TESTS_SUPPORT_PROBE_H

#include "core/pel.h"

struct probe {
    struct pel_paint paint;
    struct pel_surface surface;
    struct pel_point v[3]; /* of the present triangle, top to bottom */
    uint64_t fast, rows;   /* triangles of pel_triangle_fast, rows of all */
};

/* Bounds of 32,767 x 32,767 px around zero; the clip is all of them. */
void probe_open(struct probe *p);

/* Draws it; the first row that is wrong fails the test. */
void probe_triangle(struct probe *p, const struct pel_point v[3]);

#endif
