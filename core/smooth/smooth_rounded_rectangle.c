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

static const struct pel_smooth_sides walls = {.other = find_wall};

struct rounded {
    struct pel_smooth_outline outline;
    struct pel_smooth_curve curve;
};

static bool is_legal(const struct pel_rounded_shape *rectangle)
{
    return pel_point_legal(rectangle->from) && pel_point_legal(rectangle->to) &&
           pel_radius_legal(rectangle->radius);
}

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(struct rounded *t,
                                  const struct pel_surface *surface,
                                  const struct pel_rounded_shape *rectangle,
                                  const struct pel_paint *paint)
{
    const struct pel_point from = rectangle->from, to = rectangle->to;
    const bool legal = is_legal(rectangle);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels((struct pel_point[2]){from, to}, 2,
                              rectangle->radius));
    if (!legal || to.x <= from.x || to.y <= from.y)
        return false;
    const int32_t side = pel_min(to.x - from.x, to.y - from.y);
    const int32_t radius = pel_min(rectangle->radius, side / 2);
    const struct pel_point center = {from.x + radius, from.y + radius};
    pel_smooth_round_set(&t->outline, &t->curve, center, 0, radius);
    t->outline.spread.x = to.x - from.x - 2 * radius;
    t->outline.spread.y = to.y - from.y - 2 * radius;
    t->outline.count = 2;
    t->outline.sides = &walls;
    return pel_smooth_round_begin(surface, &t->outline, paint);
}

void pel_smooth_rounded_rectangle(const struct pel_surface *surface,
                                  const struct pel_rounded_shape *rectangle,
                                  const struct pel_paint *paint)
{
    struct rounded t;
    if (begin(&t, surface, rectangle, paint))
        pel_smooth_outline_paint(&t.outline);
}
