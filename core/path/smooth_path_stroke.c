#include "sides_smooth.h"
#include "smooth_path.h"

enum pel_status pel_smooth_path_stroke(const struct pel_surface *surface,
                                       const struct pel_path_shape *shape,
                                       const struct pel_paint *paint,
                                       void *scratch, size_t size)
{
    const struct pel_outline_source source = {pel_path_walk_stroke, shape};
    const struct pel_scratch memory = {scratch, size};
    return shape ? pel_sides_smooth(surface, &source, PEL_NON_ZERO, paint,
                                    &memory)
                 : PEL_ERROR_NULL;
}
