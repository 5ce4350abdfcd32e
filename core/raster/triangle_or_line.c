#include "line.h"
#include "triangle.h"
#include "triangle_sort.h"

static int64_t area_of(const struct pel_point v[3])
{
    return pel_product(v[1].x - v[0].x, v[2].y - v[0].y) -
           pel_product(v[2].x - v[0].x, v[1].y - v[0].y);
}

int64_t pel_triangle_area(const struct pel_point v[3])
{
    PEL_ASSERT(pel_points_legal(v, 3));
    return pel_points_legal(v, 3) ? area_of(v) : 0;
}

/* Sets the extreme vertices of a triangle without area; false when it has one,
 * or is out of range. Not inlined, to save stack. */
static PEL_NOINLINE_32 bool line_of(const struct pel_point v[3],
                                    struct pel_point ends[2])
{
    if (!pel_points_legal(v, 3) || area_of(v) != 0)
        return false;
    ends[0] = ends[1] = v[0];
    for (int i = 1; i < 3; i++) {
        if (pel_above(&v[i], &ends[0]))
            ends[0] = v[i];
        if (pel_above(&ends[1], &v[i]))
            ends[1] = v[i];
    }
    return true;
}

void pel_triangle_or_line(const struct pel_surface *surface,
                          const struct pel_point v[3],
                          const struct pel_paint *paint)
{
    struct pel_point ends[2];
    if (line_of(v, ends))
        pel_line(surface, ends[0], ends[1], paint);
    else
        pel_triangle(surface, v, paint);
}
