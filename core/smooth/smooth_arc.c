#include "smooth_arc.h"

#include "arc_parts.h"

#if !PEL_SMOOTH_TINY
/* An arc's outline: the outer circle, an end, the inner circle backwards, the
 * other end. Ends are halves of circles, or lines. */
union arc {
    struct pel_smooth_outline outline; /* of each, first */
    struct pel_smooth_round whole;
    struct {
        struct pel_smooth_lines lines;
        struct pel_smooth_curve curve[4];
        struct pel_smooth_ends ends[4];
    } round;
    struct {
        struct pel_smooth_lines lines;
        struct pel_smooth_curve curve[2];
        struct pel_smooth_ends ends[2];
        struct pel_smooth_line line[2];
    } cut;
};

/* A part of a turn, and the directions of its ends. */
struct turn {
    struct pel_angles angles;
    struct pel_point from, to;
};

static void set_curve(struct pel_smooth_outline *o, int32_t i,
                      struct pel_point center, const struct turn *turn,
                      int32_t radius)
{
    struct pel_smooth_curve *const curve = &o->curve[i];
    struct pel_smooth_ends *const ends = pel_smooth_ends_of(o, i);
    curve->center = center;
    curve->spread.x = curve->spread.y = 0;
    ends->from = pel_smooth_arc_place_at(turn->from, radius);
    ends->to = pel_smooth_arc_place_at(turn->to, radius);
    pel_smooth_circle_set(&curve->circle, radius);
    pel_smooth_arc_set_quarters(&curve->circle, turn->angles);
}

static struct pel_smooth_place middle_of(const struct pel_arc_shape *arc,
                                         struct pel_point direction)
{
    return pel_smooth_arc_place_at(direction, (arc->inner + arc->outer) >> 1);
}

/* The half of a circle at an end: clockwise from it, or to it. */
static void set_half(struct pel_smooth_outline *o, int32_t i,
                     const struct pel_arc_shape *arc, uint16_t angle,
                     struct pel_point d)
{
    const struct pel_point at =
        pel_smooth_arc_half_center(&arc->center, middle_of(arc, d));
    const struct pel_point back = {-d.x, -d.y};
    const uint16_t opposite = (uint16_t)(angle + 32768);
    const struct turn half = i == 1 ? (struct turn){{angle, opposite}, d, back}
                                    : (struct turn){{opposite, angle}, back, d};
    set_curve(o, i, at, &half, (arc->outer - arc->inner) >> 1);
}

/* The upright side that closes what rounding leaves open between curve k and
 * the next one. One of them, 1 or 3, is an end: the gap is less than 4
 * sub-pixels above or below it. */
static bool find_joint(struct pel_smooth_outline *o, int32_t y, int32_t k,
                       struct pel_smooth_crossing *c)
{
    struct pel_smooth_far_place end[2];
    const int32_t i = k & 1 ? k : (k + 1) & 3;
    const struct pel_smooth_ends *const ends = pel_smooth_ends_of(o, i);
    const int32_t at =
        o->curve[i].center.y + ((i == k ? ends->to.y : ends->from.y) >> 8);
    if (pel_magnitude(y * 256 + 128 - at) > 133)
        return false;
    pel_smooth_joint(o, k, false, end);
    c->rising = end[1].y < end[0].y;
    const int64_t x = end[!(k & 1)].x;
    c->center = (int32_t)(x >> 8);
    c->strip.at_near = c->strip.at_far = x & 255;
    c->left = false;
    return pel_smooth_upright(c, y, end[c->rising].y, end[!c->rising].y);
}

static const struct pel_smooth_sides joints = {.cut = pel_smooth_cut,
                                               .other = find_joint};

/* How far from the centre's height there is nothing of an end, 1/256 px. It
 * lies within half the width of the arc of its middle. */
static int32_t free_of(const struct pel_arc_shape *arc,
                       struct pel_point direction)
{
    return (pel_magnitude(middle_of(arc, direction).y) >> 8) -
           ((arc->outer - arc->inner) >> 1);
}

/* Between its ends an arc is as far up as down. They reach a few sub-pixels
 * further than they should. */
static void set_mirror(struct pel_smooth_outline *o,
                       const struct pel_arc_shape *arc, const struct turn *turn)
{
    const int32_t room =
        pel_min(free_of(arc, turn->from), free_of(arc, turn->to)) - 8;
    if (room > 0)
        o->mirror_from = pel_pixel_of(arc->center.y - room + 255);
}

static void set_circles(struct pel_smooth_outline *o, int32_t inner,
                        const struct pel_arc_shape *arc,
                        const struct turn *turn)
{
    set_curve(o, 0, arc->center, turn, arc->outer);
    set_curve(o, inner, arc->center, turn, arc->inner);
    o->curve[inner].circle.hole = true;
    set_mirror(o, arc, turn);
}

static void set_round(union arc *t, const struct pel_arc_shape *arc,
                      const struct turn *turn)
{
    struct pel_smooth_outline *const o = &t->outline;
    pel_smooth_lines_begin(&t->round.lines, t->round.curve, t->round.ends, NULL,
                           false);
    set_circles(o, 2, arc, turn);
    o->curves = o->count = 4;
    o->sides = &joints;
    set_half(o, 1, arc, turn->angles.to, turn->to);
    set_half(o, 3, arc, turn->angles.from, turn->from);
}

static void set_cut(union arc *t, const struct pel_arc_shape *arc,
                    const struct turn *turn)
{
    pel_smooth_lines_begin(&t->cut.lines, t->cut.curve, t->cut.ends,
                           t->cut.line, false);
    set_circles(&t->outline, 1, arc, turn);
    pel_smooth_lines_add(&t->cut.lines, &turn->to, 0);
    pel_smooth_lines_add(&t->cut.lines, &turn->from, 1);
}

static struct pel_rect box_of(const struct pel_smooth_outline *o)
{
    struct pel_rect box = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    for (int i = 0; i < o->curves; i++) {
        const struct pel_smooth_ends *const e = pel_smooth_ends_of(o, i);
        const struct pel_point c = o->curve[i].center;
        pel_smooth_arc_add_axes(&box, &o->curve[i]);
        pel_smooth_arc_widen(&box, c.x + (e->from.x >> 8),
                             c.y + (e->from.y >> 8));
        pel_smooth_arc_widen(&box, c.x + (e->to.x >> 8), c.y + (e->to.y >> 8));
    }
    return pel_smooth_arc_pixels_of(&box, 1);
}

static bool begin_whole(struct pel_smooth_round *t,
                        const struct pel_arc_shape *arc)
{
    t->center = arc->center;
    t->radius = arc->outer;
    t->spread.x = t->spread.y = 0;
    if (!pel_smooth_round_begin(t))
        return false;
    pel_smooth_round_cut(t, arc->inner);
    return true;
}

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(union arc *t, const struct pel_arc_shape *arc,
                                  bool round)
{
    struct turn turn;
    if (!pel_smooth_arc_is_legal(arc) || arc->outer <= arc->inner ||
        !pel_angles_set(&turn.angles, arc->from, arc->to))
        return false;
    if (turn.angles.from == turn.angles.to)
        return begin_whole(&t->whole, arc);
    turn.from = pel_direction(turn.angles.from);
    turn.to = pel_direction(turn.angles.to);
    (round ? set_round : set_cut)(t, arc, &turn);
    const struct pel_rect box = box_of(&t->outline);
    return pel_smooth_outline_begin(&t->outline, &box);
}

void pel_smooth_arc(const struct pel_surface *surface,
                    const struct pel_arc_shape *arc,
                    const struct pel_paint *paint)
{
    union arc t;
    t.outline.smooth = (struct pel_smooth){surface, paint};
    if (begin(&t, arc, false))
        pel_smooth_outline_paint(&t.outline);
}

void pel_smooth_arc_round(const struct pel_surface *surface,
                          const struct pel_arc_shape *arc,
                          const struct pel_paint *paint)
{
    union arc t;
    t.outline.smooth = (struct pel_smooth){surface, paint};
    if (begin(&t, arc, true))
        pel_smooth_outline_paint(&t.outline);
}

void pel_smooth_sector(const struct pel_surface *surface,
                       const struct pel_sector_shape *sector,
                       const struct pel_paint *paint)
{
    const struct pel_arc_shape arc = {sector->center, 0, sector->radius,
                                      sector->from, sector->to};
    union arc t;
    t.outline.smooth = (struct pel_smooth){surface, paint};
    if (begin(&t, &arc, false))
        pel_smooth_outline_paint(&t.outline);
}
#endif
