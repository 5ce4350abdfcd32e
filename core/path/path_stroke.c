#include "dasher.h"

enum pel_status pel_path_walk_stroke(const void *shape, struct pel_sides *sides)
{
    const struct pel_path_shape *const path = shape;
    struct pel_dasher d;
    struct pel_pen *pen;
    const enum pel_status status =
        pel_dasher_begin(&d, &path->stroke, sides, &pen);
    return status == PEL_OK ? pel_path_walk(path, pen) : status;
}

enum pel_status pel_path_stroke(const struct pel_surface *surface,
                                const struct pel_path_shape *shape,
                                const struct pel_paint *paint, void *scratch,
                                size_t size)
{
    const struct pel_outline_source source = {pel_path_walk_stroke, shape};
    const struct pel_scratch memory = {scratch, size};
    return shape
               ? pel_sides_fill(surface, &source, PEL_NON_ZERO, paint, &memory)
               : PEL_ERROR_NULL;
}

bool pel_hit_path_stroke(const struct pel_path_shape *shape, int32_t x,
                         int32_t y)
{
    const struct pel_outline_source source = {pel_path_walk_stroke, shape};
    return pel_sides_hit(&source, PEL_NON_ZERO, x, y);
}
