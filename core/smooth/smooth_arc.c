#include "smooth_arc.h"

#include "../base/trig.h"
#include "../round/angle_range.h"
#include "line_side.h"
#include "round.h"

/* A point on the ray of a direction, 2^-16 px from the centre. The length of d
 * is 2^15 (1 + e / 2), |e| < 2^-14: products are below 2^23 2^15, then 2^31
 * 2^17. */
static PEL_NOINLINE struct pel_smooth_place place_at(uint16_t angle,
                                                     int32_t radius)
{
    const struct pel_point d = pel_direction(angle);
    const int32_t e = d.x * d.x + d.y * d.y - (1 << 30); /* 2^-30 */
    const int64_t x = pel_product(d.x, radius) >> 7;
    const int64_t y = pel_product(d.y, radius) >> 7;
    return (struct pel_smooth_place){
        (int32_t)(x - (pel_long_product((int32_t)x, e) >> 31)),
        (int32_t)(y - (pel_long_product((int32_t)y, e) >> 31))};
}

/* Sets the curve of a circle between two angles. Where both lie in one quadrant
 * it goes through that one alone, or around and back to it: five. */
static PEL_NOINLINE void set_curve(struct pel_smooth_outline *o, int32_t i,
                                   struct pel_point center, struct pel_angles a,
                                   int32_t radius)
{
    struct pel_smooth_curve *const curve = &o->curve[i];
    const int32_t steps = ((a.to >> 14) - (a.from >> 14)) & 3;
    const bool back = (uint16_t)(a.to - a.from) > 16384;
    curve->center = center;
    pel_smooth_ends_of(o, i)->from = place_at(a.from, radius);
    pel_smooth_ends_of(o, i)->to = place_at(a.to, radius);
    pel_smooth_circle_set(&curve->circle, radius);
    curve->circle.first = (uint8_t)(a.from >> 14);
    curve->circle.count = (uint8_t)(steps == 0 && back ? 5 : steps + 1);
}

/* An arc's outline: the outer circle, an end, the inner circle backwards, the
 * other end. Ends are halves of circles, or lines. */
struct arc_outline {
    struct pel_smooth_lines lines; /* first */
    union {
        struct {
            struct pel_smooth_curve curve[4];
            struct pel_smooth_ends ends[4];
        } round;
        struct {
            struct pel_smooth_curve curve[2];
            struct pel_smooth_ends ends[2];
            struct pel_smooth_line line[2];
        } cut;
    } of;
};

/* How far from the centre's height there is nothing of an end, 1/256 px. It
 * lies within half the width of the arc of its middle. */
static int32_t free_of(const struct pel_arc_shape *arc, uint16_t angle)
{
    const struct pel_smooth_place middle =
        place_at(angle, (arc->inner + arc->outer) >> 1);
    return (pel_magnitude(middle.y) >> 8) - ((arc->outer - arc->inner) >> 1);
}

/* Between its ends an arc is as far up as down. They reach a few sub-pixels
 * further than they should. */
static void set_mirror(struct pel_smooth_outline *o,
                       const struct pel_arc_shape *arc,
                       struct pel_angles angles)
{
    const int32_t room =
        pel_min(free_of(arc, angles.from), free_of(arc, angles.to)) - 8;
    pel_smooth_mirror_from(
        o, room > 0 ? pel_pixel_of(arc->center.y - room + 255) : INT32_MAX);
}

static void set_half(struct pel_smooth_outline *o, int32_t i,
                     const struct pel_arc_shape *arc, uint16_t angle,
                     uint16_t turn)
{
    const struct pel_smooth_place m =
        place_at(angle, (arc->inner + arc->outer) >> 1);
    const struct pel_point at = {arc->center.x + ((m.x + 128) >> 8),
                                 arc->center.y + ((m.y + 128) >> 8)};
    const struct pel_angles angles = {(uint16_t)(angle + turn),
                                      (uint16_t)(angle + turn + 32768)};
    set_curve(o, i, at, angles, (arc->outer - arc->inner) >> 1);
}

/* The upright side that closes what rounding leaves open between curve k and
 * the next one. One of them, 1 or 3, is an end: the gap is less than 4
 * sub-pixels above or below it. */
static bool find_joint(struct pel_smooth_outline *o, int32_t y, int32_t k,
                       struct pel_smooth_crossing *c)
{
    struct pel_smooth_far_place end[2];
    const struct pel_smooth_curve *const half =
        &o->curve[k & 1 ? k : (k + 1) & 3];
    if (pel_magnitude(y * 256 + 128 - half->center.y) >
        half->circle.radius + 132)
        return false;
    pel_smooth_joint(o, k, false, end);
    c->rising = end[1].y < end[0].y;
    const int64_t x = end[!(k & 1)].x;
    c->center = (int32_t)(x >> 8);
    c->strip.at_near = c->strip.at_far = x & 255;
    c->left = false;
    return pel_smooth_upright(c, y, end[c->rising].y, end[!c->rising].y);
}

static const struct pel_smooth_sides joints = {pel_smooth_cut, find_joint};

static PEL_NOINLINE void set_outline(struct arc_outline *t,
                                     const struct pel_arc_shape *arc,
                                     struct pel_angles angles, bool round)
{
    struct pel_smooth_outline *const o = &t->lines.outline;
    const int32_t inner = round ? 2 : 1;
    pel_smooth_lines_begin(
        &t->lines, round ? t->of.round.curve : t->of.cut.curve,
        round ? t->of.round.ends : t->of.cut.ends, t->of.cut.line, false);
    set_curve(o, 0, arc->center, angles, arc->outer);
    set_curve(o, inner, arc->center, angles, arc->inner);
    o->curve[inner].circle.hole = true;
    if (!PEL_SMOOTH_TINY)
        set_mirror(o, arc, angles);
    if (round) {
        o->curves = o->count = 4;
        o->sides = &joints;
        set_half(o, 1, arc, angles.to, 0);
        set_half(o, 3, arc, angles.from, 32768);
    } else {
        pel_smooth_lines_add(&t->lines, pel_direction(angles.to), 0);
        pel_smooth_lines_add(&t->lines, pel_direction(angles.from), 1);
    }
}

static void widen(struct pel_rect *box, int32_t x, int32_t y)
{
    box->x0 = pel_min(box->x0, x);
    box->y0 = pel_min(box->y0, y);
    box->x1 = pel_max(box->x1, x);
    box->y1 = pel_max(box->y1, y);
}

/* Pixels around a curve: its ends, and the axes that it passes. */
static void add_box(struct pel_rect *box, const struct pel_smooth_outline *o,
                    int32_t i)
{
    const struct pel_smooth_curve *const curve = &o->curve[i];
    const struct pel_smooth_ends *const e = pel_smooth_ends_of(o, i);
    const struct pel_point c = curve->center;
    const int32_t r = curve->circle.radius, first = curve->circle.first;
    for (int32_t k = first + 1; k < first + curve->circle.count; k++) {
        const int32_t way = k & 2 ? -r : r;
        widen(box, c.x + (k & 1 ? 0 : way), c.y + (k & 1 ? way : 0));
    }
    widen(box, c.x + (e->from.x >> 8), c.y + (e->from.y >> 8));
    widen(box, c.x + (e->to.x >> 8), c.y + (e->to.y >> 8));
}

static struct pel_rect box_of(const struct pel_smooth_outline *o)
{
    struct pel_rect box = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    for (int i = 0; i < o->curves; i++)
        add_box(&box, o, i);
    return (struct pel_rect){pel_pixel_of(box.x0 - 1), pel_pixel_of(box.y0 - 1),
                             pel_pixel_of(box.x1 + 1) + 1,
                             pel_pixel_of(box.y1 + 1) + 1};
}

static PEL_NOINLINE bool begin_box(const struct pel_surface *surface,
                                   struct pel_smooth_outline *o,
                                   const struct pel_paint *paint)
{
    const struct pel_rect box = box_of(o);
    return pel_smooth_outline_begin(o, surface, &box, paint);
}

static bool is_legal(const struct pel_arc_shape *arc)
{
    return pel_point_legal(arc->center) && pel_radius_legal(arc->inner) &&
           pel_radius_legal(arc->outer);
}

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(const struct pel_surface *surface,
                                  struct arc_outline *t,
                                  const struct pel_arc_shape *arc, bool round,
                                  const struct pel_paint *paint)
{
    struct pel_smooth_outline *const o = &t->lines.outline;
    struct pel_angles angles;
    const bool legal = is_legal(arc);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&arc->center, 1, arc->outer));
    if (!legal || arc->outer <= arc->inner ||
        !pel_angles_set(&angles, arc->from, arc->to))
        return false;
    if (angles.from == angles.to) {
        pel_smooth_round_set(o, t->of.cut.curve, arc->center, arc->inner,
                             arc->outer);
        return pel_smooth_round_begin(surface, o, paint);
    }
    set_outline(t, arc, angles, round);
    return begin_box(surface, o, paint);
}

void pel_smooth_arc(const struct pel_surface *surface,
                    const struct pel_arc_shape *arc,
                    const struct pel_paint *paint)
{
    struct arc_outline t;
    if (begin(surface, &t, arc, false, paint))
        pel_smooth_outline_paint(&t.lines.outline);
}

void pel_smooth_arc_round(const struct pel_surface *surface,
                          const struct pel_arc_shape *arc,
                          const struct pel_paint *paint)
{
    struct arc_outline t;
    if (begin(surface, &t, arc, true, paint))
        pel_smooth_outline_paint(&t.lines.outline);
}

static PEL_NOINLINE_32 bool begin_sector(const struct pel_surface *surface,
                                         struct arc_outline *t,
                                         const struct pel_sector_shape *sector,
                                         const struct pel_paint *paint)
{
    const struct pel_arc_shape arc = {sector->center, 0, sector->radius,
                                      sector->from, sector->to};
    return begin(surface, t, &arc, false, paint);
}

void pel_smooth_sector(const struct pel_surface *surface,
                       const struct pel_sector_shape *sector,
                       const struct pel_paint *paint)
{
    struct arc_outline t;
    if (begin_sector(surface, &t, sector, paint))
        pel_smooth_outline_paint(&t.lines.outline);
}
