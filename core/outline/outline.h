/* Outlines one pixel wide: the pixels of a fill that have a neighbour (left,
 * right, above or below) outside of the shape. An outline lies inside the fill
 * and is as symmetric. Other shapes: outline_filter.h. The edge of the clip is
 * no outline. Ranges and errors are those of the fills. */
#ifndef PEL_OUTLINE_OUTLINE_H
#define PEL_OUTLINE_OUTLINE_H

#include "../raster/polygon.h"
#include "../round/ellipse.h"
#include "../round/rounded_rectangle.h"
#include "../round/sector.h"
#include "outline_filter.h"

PEL_BEGIN_DECLS

void pel_triangle_outline(const struct pel_surface *surface,
                          const struct pel_point v[3],
                          const struct pel_paint *paint);

void pel_rectangle_outline(const struct pel_surface *surface,
                           struct pel_point from, struct pel_point to,
                           const struct pel_paint *paint);

void pel_rounded_rectangle_outline(const struct pel_surface *surface,
                                   const struct pel_rounded_shape *r,
                                   const struct pel_paint *paint);

void pel_circle_outline(const struct pel_surface *surface,
                        struct pel_point center, int32_t radius,
                        const struct pel_paint *paint);

void pel_ellipse_outline(const struct pel_surface *surface,
                         const struct pel_ellipse_shape *ellipse,
                         const struct pel_paint *paint);

/* The pixels of the outline of pel_circle(center, radius) that belong to the
 * sector: an arc one pixel wide. Such arcs tile as sectors do. */
void pel_arc_outline(const struct pel_surface *surface,
                     const struct pel_sector_shape *sector,
                     const struct pel_paint *paint);

/* Scratch memory as for pel_polygon, of another size: that of the polygon, the
 * filter, aligned like a pointer, and its spans, n / 2 a row at most. 0 when
 * n < 1, or when the size does not fit. */
#define PEL_POLYGON_OUTLINE_SCRATCH_SIZE(n)                            \
    (PEL_POLYGON_SCRATCH_SIZE(n) + sizeof(struct pel_outline_filter) + \
     sizeof(void *) - 4 +                                              \
     PEL_OUTLINE_FILTER_SPANS(PEL_CAST(size_t, n) / 2) *               \
         sizeof(struct pel_span))
size_t pel_polygon_outline_scratch_size(int32_t n);
enum pel_status pel_polygon_outline(const struct pel_surface *surface,
                                    const struct pel_polygon_shape *polygon,
                                    const struct pel_paint *paint,
                                    void *scratch, size_t size);
PEL_END_DECLS
#endif
