/* Smooth paths and strokes. */
#ifndef PEL_PATH_SMOOTH_PATH_H
#define PEL_PATH_SMOOTH_PATH_H

#include "../smooth/smooth_polygon.h"
#include "path.h"

PEL_BEGIN_DECLS

/* Bytes of scratch memory, aligned to 8, for so many sides in a row, on a
 * surface whose clip is `width` px wide. A stroke has about 8 for each line
 * that touches a row, with round joins of 2 px, and 20 of 10 px. */
#define PEL_SMOOTH_PATH_SCRATCH_SIZE(sides, width) \
    (PEL_SMOOTH_POLYGON_SCRATCH_SIZE(sides, width) + 88 * sizeof(void *))

/* What the functions of path.h draw, each pixel by the part of it that is
 * inside, as pel_smooth_polygon does: within .5 + .02 k of 255, where k pieces
 * of the border go through the pixel, also where a stroke crosses itself.
 * Errors are the same, and PEL_ERROR_SCRATCH where the memory is too small for
 * the sums of a row or, of a stroke as of a fill, for the sides in one. */
enum pel_status pel_smooth_path_fill(const struct pel_surface *surface,
                                     const struct pel_path_shape *shape,
                                     const struct pel_paint *paint,
                                     void *scratch, size_t size);
enum pel_status pel_smooth_path_stroke(const struct pel_surface *surface,
                                       const struct pel_path_shape *shape,
                                       const struct pel_paint *paint,
                                       void *scratch, size_t size);
enum pel_status pel_smooth_polyline(const struct pel_surface *surface,
                                    const struct pel_polyline_shape *line,
                                    const struct pel_paint *paint,
                                    void *scratch, size_t size);
PEL_END_DECLS
#endif
