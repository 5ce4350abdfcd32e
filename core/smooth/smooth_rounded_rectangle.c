#include "smooth_rounded_rectangle.h"

#include "round.h"

/* The left side between two quarters, and the right one. */
static bool find_wall(struct pel_smooth_outline *o, int32_t y, int32_t i,
                      struct pel_smooth_crossing *c)
{
    const struct pel_smooth_curve *const b = o->curve;
    const int32_t from = pel_max(b->center.y, y * 256);
    const int32_t to = pel_min(b->center.y + o->spread.y, y * 256 + 256);
    c->left = c->rising = i == 0;
    c->center = i == 0 ? -b->center.x : b->center.x + o->spread.x;
    c->strip.circle = NULL;
    c->strip.near = 0;
    c->strip.far = (to - from) * 256;
    c->strip.at_near = c->strip.at_far = b->circle.reach;
    return from < to;
}

void pel_smooth_rounded_rectangle(const struct pel_surface *surface,
                                  const struct pel_rounded_shape *rectangle,
                                  const struct pel_paint *paint)
{
    const struct pel_point from = rectangle->from, to = rectangle->to;
    struct pel_smooth_outline outline;
    struct pel_smooth_curve curve;
    const bool legal = pel_point_legal(from) && pel_point_legal(to) &&
                       pel_radius_legal(rectangle->radius);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels((struct pel_point[2]){from, to}, 2,
                              rectangle->radius));
    if (!legal || to.x <= from.x || to.y <= from.y)
        return;
    const int32_t side = pel_min(to.x - from.x, to.y - from.y);
    const int32_t radius = pel_min(rectangle->radius, side / 2);
    const struct pel_point center = {from.x + radius, from.y + radius};
    pel_smooth_round_set(&outline, &curve, center, 0, radius);
    outline.spread.x = to.x - from.x - 2 * radius;
    outline.spread.y = to.y - from.y - 2 * radius;
    outline.count = 2;
    outline.others = pel_smooth_others;
    outline.other = find_wall;
    if (pel_smooth_round_begin(surface, &outline, paint))
        pel_smooth_outline_paint(&outline);
}
