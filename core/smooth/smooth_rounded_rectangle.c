#include "smooth_rounded_rectangle.h"

#include "round_rows.h"

void pel_smooth_rounded_rectangle(const struct pel_surface *surface,
                                  const struct pel_rounded_shape *rectangle,
                                  const struct pel_paint *paint)
{
    const struct pel_point from = rectangle->from, to = rectangle->to;
    const bool legal = pel_point_legal(from) && pel_point_legal(to) &&
                       pel_radius_legal(rectangle->radius);
    struct pel_smooth_rows rows;
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels((struct pel_point[2]){from, to}, 2,
                              rectangle->radius));
    if (!legal || to.x <= from.x || to.y <= from.y)
        return;
    const int32_t side = pel_min(to.x - from.x, to.y - from.y);
    const int32_t radius = pel_min(rectangle->radius, side / 2);
    rows.round = (struct pel_smooth_round){
        from.x + radius, to.x - radius, from.y + radius, to.y - radius, radius};
    if (pel_smooth_rows_begin(&rows, surface, paint))
        pel_smooth_rows_all(&rows);
}
