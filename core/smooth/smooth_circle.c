#include "smooth_circle.h"

#include "round.h"

void pel_smooth_circle(const struct pel_surface *surface,
                       struct pel_point center, int32_t radius,
                       const struct pel_paint *paint)
{
    const bool legal = pel_point_legal(center) && pel_radius_legal(radius);
    struct pel_smooth_outline disc;
    struct pel_smooth_curve curve;
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&center, 1, radius));
    if (!legal || radius == 0)
        return;
    pel_smooth_round_set(&disc, &curve, center, 0, radius);
    if (pel_smooth_round_begin(surface, &disc, paint))
        pel_smooth_outline_paint(&disc);
}
