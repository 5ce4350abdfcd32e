#include "smooth_circle.h"

#include "round.h"

#if PEL_SMOOTH_TINY
static const struct pel_smooth_kind discs = {.curves = 1,
                                             .curve = pel_smooth_round_curve};

static PEL_ALWAYS_INLINE void paint_disc(struct pel_smooth_round *disc)
{
    pel_smooth_short_outline_paint(&disc->outline, &discs);
}
#else
static inline void paint_disc(struct pel_smooth_round *disc)
{
    pel_smooth_outline_paint(&disc->outline);
}
#endif

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(struct pel_smooth_round *disc)
{
    const int32_t radius = disc->radius;
    const bool legal =
        pel_point_legal(disc->center) && pel_radius_legal(radius);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&disc->center, 1, radius));
    return legal && radius > 0 && pel_smooth_round_begin(disc);
}

void pel_smooth_circle(const struct pel_surface *surface,
                       struct pel_point center, int32_t radius,
                       const struct pel_paint *paint)
{
    struct pel_smooth_round disc;
    disc.outline.smooth = (struct pel_smooth){surface, paint};
    disc.center.x = center.x;
    disc.center.y = center.y;
    disc.radius = radius;
    disc.spread.x = disc.spread.y = 0;
    if (begin(&disc))
        paint_disc(&disc);
}
