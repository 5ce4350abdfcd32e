/* Filled polygons with any number of vertices. */
#ifndef PEL_RASTER_POLYGON_H
#define PEL_RASTER_POLYGON_H

#include "paint.h"

PEL_BEGIN_DECLS

enum pel_fill_rule {
    PEL_EVEN_ODD, /* inside: a ray crosses the outline an odd number of times */
    PEL_NON_ZERO  /* inside: the outline winds around the point */
};

struct pel_polygon_shape {
    const struct pel_point *v; /* the outline is closed from the last to v[0] */
    int32_t n;                 /* vertices; fewer than 3 cover nothing */
    enum pel_fill_rule rule;
};

/* Bytes of scratch memory, aligned to 4, that a polygon of n vertices needs,
 * for constant expressions; and the same as a function: 0 when n < 1, or when
 * the size does not fit. */
#define PEL_POLYGON_SCRATCH_SIZE(n) (PEL_CAST(size_t, n) * 36 + 20)
size_t pel_polygon_scratch_size(int32_t n);

/* Fills the pixels whose centre is inside, by the rule of raster/edge.h for
 * centres on an edge: polygons and triangles that share edges cover every pixel
 * once. The outline may cross itself; no pixel is painted twice. Scratch memory
 * is the caller's and may be used again after the call.
 * Time is O(n^1.5) at most, plus O(m) for every visible row that m sides cross,
 * O(m^1.5) where some begin, and a step for every two that cross each other.
 * PEL_ERROR_NULL, PEL_ERROR_SCRATCH (too small, or not aligned to 4),
 * PEL_ERROR_RANGE (a vertex out of range): nothing is drawn then. */
enum pel_status pel_polygon(const struct pel_surface *surface,
                            const struct pel_polygon_shape *polygon,
                            const struct pel_paint *paint, void *scratch,
                            size_t size);

/* 1 when the box of a polygon of n >= 1 vertices has pixels inside the clip;
 * otherwise PEL_OK or PEL_ERROR_RANGE. */
int pel_polygon_visible(const struct pel_polygon_shape *polygon,
                        const struct pel_rect *clip);
PEL_END_DECLS
#endif
