#include "dasher.h"

enum pel_status pel_polyline_walk(const void *shape, struct pel_sides *sides)
{
    const struct pel_polyline_shape *const line = shape;
    struct pel_dasher d;
    struct pel_pen *pen;
    enum pel_status status = pel_dasher_begin(&d, &line->stroke, sides, &pen);
    if (line->n > 0 && !line->v)
        return PEL_ERROR_NULL;
    for (int32_t i = 0; i < line->n && status == PEL_OK; i++) {
        status = pen->draw(pen, i ? PEL_LINE : PEL_MOVE, &line->v[i]);
        if (line->n == 1 && status == PEL_OK)
            status = pen->draw(pen, PEL_LINE, line->v);
    }
    if (line->closed && line->n > 0 && status == PEL_OK)
        status = pen->draw(pen, PEL_CLOSE, NULL);
    return status == PEL_OK ? pen->draw(pen, PEL_MOVE, NULL) : status;
}

enum pel_status pel_polyline(const struct pel_surface *surface,
                             const struct pel_polyline_shape *line,
                             const struct pel_paint *paint, void *scratch,
                             size_t size)
{
    const struct pel_outline_source source = {pel_polyline_walk, line};
    const struct pel_scratch memory = {scratch, size};
    return line ? pel_sides_fill(surface, &source, PEL_NON_ZERO, paint, &memory)
                : PEL_ERROR_NULL;
}

bool pel_hit_polyline(const struct pel_polyline_shape *line, int32_t x,
                      int32_t y)
{
    const struct pel_outline_source source = {pel_polyline_walk, line};
    return pel_sides_hit(&source, PEL_NON_ZERO, x, y);
}
