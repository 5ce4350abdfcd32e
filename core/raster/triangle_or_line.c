#include "line.h"
#include "triangle.h"
#include "triangle_sort.h"

int64_t pel_triangle_area(const struct pel_point v[3])
{
    PEL_ASSERT(pel_points_legal(v, 3));
    return pel_points_legal(v, 3) ? pel_corners_area(v) : 0;
}

/* The extreme vertices of a triangle without area, 4 first + last; -1 when it
 * has one, or is out of range. Not inlined, to save stack. */
static PEL_NOINLINE_32 int line_of(const struct pel_point v[3])
{
    int first = 0, last = 0;
    if (!pel_points_legal(v, 3) || pel_corners_area(v) != 0)
        return -1;
    for (int i = 1; i < 3; i++) {
        if (pel_above(&v[i], &v[first]))
            first = i;
        if (pel_above(&v[last], &v[i]))
            last = i;
    }
    return 4 * first + last;
}

static PEL_STEP void draw_line(const struct pel_surface *surface,
                               const struct pel_point v[3], int ends,
                               const struct pel_paint *paint)
{
    pel_line(surface, v[ends >> 2], v[ends & 3], paint);
}

void pel_triangle_or_line(const struct pel_surface *surface,
                          const struct pel_point v[3],
                          const struct pel_paint *paint)
{
    const int ends = line_of(v);
    if (ends < 0)
        pel_triangle(surface, v, paint);
    else
        draw_line(surface, v, ends, paint);
}
