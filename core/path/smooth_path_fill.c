#include "sides_smooth.h"
#include "smooth_path.h"

enum pel_status pel_smooth_path_fill(const struct pel_surface *surface,
                                     const struct pel_path_shape *shape,
                                     const struct pel_paint *paint,
                                     void *scratch, size_t size)
{
    const struct pel_outline_source source = {pel_path_walk_fill, shape};
    const struct pel_scratch memory = {scratch, size};
    return shape
               ? pel_sides_smooth(surface, &source, shape->rule, paint, &memory)
               : PEL_ERROR_NULL;
}
