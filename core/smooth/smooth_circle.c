#include "smooth_circle.h"

#include "round.h"

void pel_smooth_circle(const struct pel_surface *surface,
                       struct pel_point center, int32_t radius,
                       const struct pel_paint *paint)
{
    const bool legal = pel_point_legal(center) && pel_radius_legal(radius);
    const struct pel_smooth_round disc = {center, {0, 0}, 0,
                                          radius, NULL,   NULL};
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&center, 1, radius));
    if (legal && radius > 0)
        pel_smooth_round(surface, &disc, paint);
}
