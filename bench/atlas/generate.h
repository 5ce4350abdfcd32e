/* Triangles of the regimes where methods fail. */
#ifndef BENCH_ATLAS_GENERATE_H
#define BENCH_ATLAS_GENERATE_H

#include <pel/pel.h>

#include "../random.h"

/* A square of whole pixels that holds the triangles. */
struct square {
    int32_t x, y, edge; /* px */
};

/* Vertices anywhere in the square. */
void any_triangle(struct random *r, const struct square *p,
                  struct pel_point v[3]);

/* Vertices on pixel centres, a sub-pixel beside them, in line, on one row or in
 * one column: centres on edges. */
void tied_triangle(struct random *r, const struct square *p,
                   struct pel_point v[3]);

/* A long edge of `length` px and a third vertex `thickness` sub-pixels
 * off it. */
struct thin {
    int32_t length, thickness;
};
void thin_triangle(struct random *r, const struct square *p,
                   const struct thin *thin, struct pel_point v[3]);

/* Edges that go anywhere in a square of `edge` px around the middle of the
 * range, the largest 65,535 px; a point of one of them, px. */
struct pel_point far_triangle(struct random *r, int32_t edge,
                              struct pel_point v[3]);

/* A mesh over the whole square, of n x n cells: vertices on half pixels. A cell
 * is two triangles; the mesh holds each pixel once. */
struct grid {
    struct square square;
    int32_t n;
    struct pel_point *vertex; /* (n + 1)^2 */
};
void grid_make(struct random *r, struct grid *g);

/* Triangle 0 or 1 of a cell; its first vertex is any of the three. */
void grid_triangle(const struct grid *g, int32_t cell, int half,
                   struct pel_point v[3]);

#endif
