#include "smooth_circle.h"

#include "round_rows.h"

void pel_smooth_circle(const struct pel_surface *surface,
                       struct pel_point center, int32_t radius,
                       const struct pel_paint *paint)
{
    const bool legal = pel_point_legal(center) && pel_radius_legal(radius);
    struct pel_smooth_rows rows;
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&center, 1, radius));
    rows.round = (struct pel_smooth_round){center.x, center.x, center.y,
                                           center.y, radius};
    if (legal && radius > 0 && pel_smooth_rows_begin(&rows, surface, paint))
        pel_smooth_rows_all(&rows);
}
