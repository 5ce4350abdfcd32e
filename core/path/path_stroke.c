#include "stroker.h"

enum pel_status pel_path_stroke(const struct pel_surface *surface,
                                const struct pel_path_shape *shape,
                                const struct pel_paint *paint, void *scratch,
                                size_t size)
{
    const struct pel_scratch memory = {scratch, size};
    if (!shape)
        return PEL_ERROR_NULL;
    const struct pel_lines lines = {pel_path_walk, shape, &shape->stroke};
    return pel_stroke_fill(surface, &lines, paint, &memory);
}

bool pel_hit_path_stroke(const struct pel_path_shape *shape, int32_t x,
                         int32_t y)
{
    const struct pel_lines lines = {pel_path_walk, shape, &shape->stroke};
    return pel_stroke_hit(&lines, x, y);
}
