#include "stroker.h"

/* Behind the points from i on that lie on one side of the rows, as point i - 1
 * does: one line goes there for all, if there are any. */
static PEL_NOINLINE_32 int32_t skip(const struct pel_polyline_shape *line,
                                    int32_t i, const struct pel_pen *pen)
{
    const uint32_t all = 2 * (uint32_t)pen->most;
    int32_t low = -pen->most, high = pen->most;
    if (line->v[i - 1].y < pen->top)
        high = pen->top - 1;
    else if (line->v[i - 1].y > pen->bottom)
        low = pen->bottom + 1;
    else
        return i;
    while (i < line->n && line->v[i].y >= low && line->v[i].y <= high &&
           (uint32_t)line->v[i].x + (uint32_t)pen->most <= all)
        i++;
    return i;
}

enum pel_status pel_polyline_walk(const void *shape, struct pel_pen *pen)
{
    const struct pel_polyline_shape *const line = shape;
    enum pel_status status = PEL_OK;
    if (line->n > 0 && !line->v)
        return PEL_ERROR_NULL;
    PEL_HINT(pel_in_subpixels(line->v, line->n, 0));
    for (int32_t i = 0; i < line->n && status == PEL_OK; i++) {
        if (i > 0)
            i = pel_max(i, skip(line, i, pen) - 1);
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
    const struct pel_scratch memory = {scratch, size};
    if (!line)
        return PEL_ERROR_NULL;
    const struct pel_lines lines = {pel_polyline_walk, line, &line->stroke};
    return pel_stroke_fill(surface, &lines, paint, &memory);
}

bool pel_hit_polyline(const struct pel_polyline_shape *line, int32_t x,
                      int32_t y)
{
    const struct pel_lines lines = {pel_polyline_walk, line, &line->stroke};
    return pel_stroke_hit(&lines, x, y);
}
