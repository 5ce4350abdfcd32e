/* The outline of any shape: a filter between a shape and a paint, which lets
 * through the pixels of the shape that have a neighbour (left, right, above or
 * below) outside of it. So an outline lies inside its fill, is as symmetric as
 * that is, is one pixel wide and closed (its pixels touch at corners at least),
 * and painting fill minus outline and outline hits every pixel of the fill
 * once.
 *
 * The shape is drawn on the rim's own surface with the rim's own paint:
 *
 *     struct pel_span memory[PEL_RIM_MEMORY(2)];
 *     struct pel_rim rim;
 *     if (pel_rim_begin(&rim, surface, paint, memory, PEL_RIM_MEMORY(2))) {
 *         pel_ring(&rim.surface, &ring, &rim.paint);
 *         pel_rim_end(&rim);
 *     }
 *
 * That surface is the given one with a clip larger by one pixel on every side,
 * so that a clip does not make an edge; its pixels are not touched. Unlike
 * other paints the rim has a state: the shape must hand it its rows from the
 * top down, as all shapes of core do, each row from left to right. */
#ifndef PEL_OUTLINE_RIM_H
#define PEL_OUTLINE_RIM_H

#include "../raster/paint.h"

/* Runs of memory for shapes with at most n runs in a row: 1 for those without
 * a dent or hole, 2 for a ring, 3 for an arc, half of the vertices for a
 * polygon. Runs beyond n in a row are left out. */
#define PEL_RIM_MEMORY(n) (3 * (n))

struct pel_rim_line {
    struct pel_span *run;
    int32_t n;
};

enum { PEL_RIM_PIECES = 4 };

struct pel_rim {
    struct pel_paint paint;
    struct pel_surface surface;
    const struct pel_paint *out;
    struct pel_spans spans; /* pieces of row y - 1 */
    struct pel_span piece[PEL_RIM_PIECES];
    struct pel_rim_line line[3]; /* rows y - 2, y - 1 and y */
    int32_t y, capacity;
    int32_t x, at[3]; /* row y - 1 is cut up to x, and to which runs of each */
};

/* `runs` is the number of runs of memory, a multiple of 3; the memory is the
 * caller's and free again after the end. false: nothing can be covered, and no
 * end is needed. */
bool pel_rim_begin(struct pel_rim *rim, const struct pel_surface *surface,
                   const struct pel_paint *paint, struct pel_span *memory,
                   int32_t runs);

void pel_rim_end(struct pel_rim *rim);

#endif
