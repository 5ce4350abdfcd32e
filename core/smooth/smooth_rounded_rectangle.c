#include "smooth_rounded_rectangle.h"

#include "round.h"

/* The left side between two quarters, and the right one. */
static bool wall_in(const struct pel_smooth_curve *b, int32_t y, int32_t i,
                    struct pel_smooth_crossing *c)
{
    const int32_t from = pel_max(b->center.y, y * 256);
    const int32_t to = pel_min(b->center.y + b->spread.y, y * 256 + 256);
    c->left = c->rising = i == 0;
    c->center = i == 0 ? -b->center.x : b->center.x + b->spread.x;
    c->strip.circle = NULL;
    c->strip.near = 0;
    c->strip.far = (to - from) * 256;
    c->strip.at_near = c->strip.at_far = pel_smooth_reach(&b->circle);
    return from < to;
}

#if PEL_SMOOTH_TINY
static bool find_wall(const struct pel_smooth_short_outline *outline, int32_t i,
                      struct pel_smooth_crossing *c)
{
    struct pel_smooth_curve curve;
    pel_smooth_round_curve(outline, 0, &curve);
    return wall_in(&curve, outline->seen.y, i, c);
}

static const struct pel_smooth_kind walls = {.curves = 1,
                                             .others = 2,
                                             .curve = pel_smooth_round_curve,
                                             .other = find_wall};

static PEL_ALWAYS_INLINE void paint_rounded(struct pel_smooth_round *t)
{
    pel_smooth_short_outline_paint(&t->outline, &walls);
}
#else
static bool find_wall(struct pel_smooth_outline *o, int32_t y, int32_t i,
                      struct pel_smooth_crossing *c)
{
    return wall_in(o->curve, y, i, c);
}

/* It is in a row what it was in the one above. */
static void stay(struct pel_smooth_outline *o, int32_t i,
                 struct pel_smooth_crossing *c)
{
    (void)o;
    (void)i;
    (void)c;
}

static const struct pel_smooth_sides walls = {.other = find_wall, .down = stay};

static inline void paint_rounded(struct pel_smooth_round *t)
{
    t->outline.sides = &walls;
    t->outline.count = 2;
    pel_smooth_outline_paint(&t->outline);
}
#endif

static bool is_legal(const struct pel_rounded_shape *rectangle)
{
    return pel_point_legal(rectangle->from) && pel_point_legal(rectangle->to) &&
           pel_radius_legal(rectangle->radius);
}

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(struct pel_smooth_round *t,
                                  const struct pel_rounded_shape *rectangle)
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
    t->center = (struct pel_point){from.x + radius, from.y + radius};
    t->spread.x = to.x - from.x - 2 * radius;
    t->spread.y = to.y - from.y - 2 * radius;
    t->radius = radius;
    return pel_smooth_round_begin(t);
}

void pel_smooth_rounded_rectangle(const struct pel_surface *surface,
                                  const struct pel_rounded_shape *rectangle,
                                  const struct pel_paint *paint)
{
    struct pel_smooth_round t;
    t.outline.smooth = (struct pel_smooth){surface, paint};
    if (begin(&t, rectangle))
        paint_rounded(&t);
}
