#include "round.h"

static void set_circle(struct pel_smooth_curve *curve, struct pel_point center,
                       int32_t radius, bool hole)
{
    curve->center = center;
    pel_smooth_circle_set(&curve->circle, radius);
    curve->circle.hole = hole;
}

void pel_smooth_round_set(struct pel_smooth_outline *o,
                          struct pel_smooth_curve *curve,
                          struct pel_point center, int32_t inner, int32_t outer)
{
    o->spread.x = o->spread.y = 0;
    pel_smooth_mirror_from(o, INT32_MIN);
    o->curve = curve;
    o->curves = inner > 0 ? 2 : 1;
    o->sides = NULL;
    o->count = 0;
    set_circle(curve, center, outer, false);
    if (inner > 0)
        set_circle(curve + 1, center, inner, true);
}

/* The box has the column left of what a shape covers, too: as the mirror image
 * of one on the right it may be a pixel of coverage 0 that is read and stored.
 */
bool pel_smooth_round_begin(const struct pel_surface *surface,
                            struct pel_smooth_outline *o,
                            const struct pel_paint *paint)
{
    const struct pel_smooth_circle *const circle = &o->curve->circle;
    const struct pel_point c = o->curve->center,
                           far = {c.x + o->spread.x, c.y + o->spread.y};
    const int32_t width = circle->reach >> 8, height = circle->radius;
    const struct pel_rect box = {
        pel_pixel_of(c.x - width - 1), pel_pixel_of(c.y - height),
        pel_pixel_of(far.x + width) + 1, pel_pixel_of(far.y + height + 255)};
    return pel_smooth_outline_begin(o, surface, &box, paint);
}
