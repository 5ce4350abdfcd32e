#include "smooth_circle.h"

#include "round.h"

struct disc {
    struct pel_smooth_outline outline;
    struct pel_smooth_curve curve;
};

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(struct disc *disc,
                                  const struct pel_surface *surface,
                                  struct pel_point center, int32_t radius,
                                  const struct pel_paint *paint)
{
    const bool legal = pel_point_legal(center) && pel_radius_legal(radius);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&center, 1, radius));
    if (!legal || radius == 0)
        return false;
    pel_smooth_round_set(&disc->outline, &disc->curve, center, 0, radius);
    return pel_smooth_round_begin(surface, &disc->outline, paint);
}

void pel_smooth_circle(const struct pel_surface *surface,
                       struct pel_point center, int32_t radius,
                       const struct pel_paint *paint)
{
    struct disc disc;
    if (begin(&disc, surface, center, radius, paint))
        pel_smooth_outline_paint(&disc.outline);
}
