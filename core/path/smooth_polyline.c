#include "sides_smooth.h"
#include "smooth_path.h"

enum pel_status pel_smooth_polyline(const struct pel_surface *surface,
                                    const struct pel_polyline_shape *line,
                                    const struct pel_paint *paint,
                                    void *scratch, size_t size)
{
    const struct pel_outline_source source = {pel_polyline_walk, line};
    const struct pel_scratch memory = {scratch, size};
    return line ? pel_sides_smooth(surface, &source, PEL_NON_ZERO, paint,
                                   &memory)
                : PEL_ERROR_NULL;
}
