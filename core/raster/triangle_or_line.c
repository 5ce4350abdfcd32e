#include "line.h"
#include "triangle.h"
#include "triangle_sort.h"

int64_t pel_triangle_area(const struct pel_point v[3])
{
    PEL_ASSERT(pel_points_legal(v, 3));
    if (!pel_points_legal(v, 3))
        return 0;
    return (int64_t)(v[1].x - v[0].x) * (v[2].y - v[0].y) -
           (int64_t)(v[2].x - v[0].x) * (v[1].y - v[0].y);
}

void pel_triangle_or_line(const struct pel_surface *surface,
                          const struct pel_point v[3],
                          const struct pel_paint *paint)
{
    const struct pel_point *p[3] = {&v[0], &v[1], &v[2]};
    if (!pel_points_legal(v, 3) || pel_triangle_area(v) != 0) {
        pel_triangle(surface, v, paint);
        return;
    }
    pel_sort3(p);
    pel_line(surface, *p[0], *p[2], paint);
}
