#include "smooth_arc.h"

#include "../base/trig.h"
#include "../round/angle_range.h"
#include "path.h"

/* A point on the ray of direction d, 2^-16 px from its beginning. The length of
 * d is 2^15 (1 + e / 2), |e| < 2^-14: products are below 2^23 2^15, then 2^31
 * 2^17. */
static struct pel_smooth_place place_at(struct pel_point d, int32_t radius)
{
    const int32_t e = d.x * d.x + d.y * d.y - (1 << 30); /* 2^-30 */
    const int64_t x = pel_product(d.x, radius) >> 7;
    const int64_t y = pel_product(d.y, radius) >> 7;
    return (struct pel_smooth_place){
        (int32_t)(x - (pel_long_product((int32_t)x, e) >> 31)),
        (int32_t)(y - (pel_long_product((int32_t)y, e) >> 31))};
}

/* Closes what rounding leaves open between two heights: `at` and 2^-16 px from
 * there is a point near by. */
static void add_gap(struct pel_smooth_path *path, struct pel_point at,
                    int32_t x, int64_t from, int64_t to)
{
    const struct pel_smooth_way down = {at, {0, 1}, {x, 0}};
    pel_smooth_path_line(path, &down, from, to);
}

/* An end of an arc: at its beginning the outline goes outwards. */
struct end {
    const struct pel_arc_shape *arc;
    uint16_t angle;
    bool begins;
};

/* The height of the ray of an end at the circle where the outline comes, or
 * where it goes on. */
static int64_t height_of(const struct end *end, bool comes)
{
    const struct pel_arc_shape *const arc = end->arc;
    const int32_t radius = end->begins == comes ? arc->inner : arc->outer;
    const struct pel_smooth_place p =
        place_at(pel_direction(end->angle), radius);
    return (int64_t)arc->center.y * 256 + p.y;
}

/* The centre of a half disc. */
static struct pel_point center_of(const struct end *end)
{
    const struct pel_arc_shape *const arc = end->arc;
    const struct pel_smooth_place m =
        place_at(pel_direction(end->angle), (arc->inner + arc->outer) >> 1);
    return (struct pel_point){arc->center.x + ((m.x + 128) >> 8),
                              arc->center.y + ((m.y + 128) >> 8)};
}

static void add_half(struct pel_smooth_path *path, const struct end *end)
{
    const int32_t radius = (end->arc->outer - end->arc->inner) >> 1;
    const struct pel_point at = center_of(end);
    const int64_t y = (int64_t)at.y * 256;
    const uint16_t angle = (uint16_t)(end->angle + (end->begins ? 32768 : 0));
    const struct pel_smooth_place p = place_at(pel_direction(angle), radius);
    const struct pel_smooth_bow bow = {.center = at,
                                       .from = p,
                                       .to = {-p.x, -p.y},
                                       .first = (uint8_t)(angle >> 14),
                                       .count = 3};
    add_gap(path, at, p.x, height_of(end, true), y + p.y);
    if (radius > 0)
        pel_smooth_path_bow(path, &bow, radius);
    add_gap(path, at, -p.x, y - p.y, height_of(end, false));
}

static void add_ray(struct pel_smooth_path *path, const struct end *end)
{
    const struct pel_smooth_way ray = {
        end->arc->center, pel_direction(end->angle), {0, 0}};
    pel_smooth_path_line(path, &ray, height_of(end, true),
                         height_of(end, false));
}

/* Once through a quadrant, or back to it. */
static uint8_t quadrants_of(struct pel_angles a)
{
    const int32_t steps = ((a.to >> 14) - (a.from >> 14)) & 3;
    const bool back = a.from == a.to || (uint16_t)(a.to - a.from) > 16384;
    return (uint8_t)(steps == 0 && back ? 5 : steps + 1);
}

static void add_circle(struct pel_smooth_path *path, struct pel_point center,
                       struct pel_angles angles, int32_t radius, bool hole)
{
    const struct pel_smooth_bow bow = {
        .center = center,
        .from = place_at(pel_direction(angles.from), radius),
        .to = place_at(pel_direction(angles.to), radius),
        .first = (uint8_t)(angles.from >> 14),
        .count = quadrants_of(angles),
        .hole = hole};
    if (radius > 0)
        pel_smooth_path_bow(path, &bow, radius);
}

/* The circles of the arc, and the two ends, if it has any. */
static PEL_NOINLINE_32 void add_outline(struct pel_smooth_path *path,
                                        const struct pel_arc_shape *arc,
                                        struct pel_angles angles, bool round)
{
    const struct end begin = {arc, angles.from, true};
    const struct end end = {arc, angles.to, false};
    add_circle(path, arc->center, angles, arc->outer, false);
    add_circle(path, arc->center, angles, arc->inner, true);
    if (angles.from == angles.to)
        return;
    (round ? add_half : add_ray)(path, &begin);
    (round ? add_half : add_ray)(path, &end);
}

static bool is_legal(const struct pel_arc_shape *arc)
{
    return pel_point_legal(arc->center) && pel_radius_legal(arc->inner) &&
           pel_radius_legal(arc->outer);
}

/* The pixels of the clip that the arc may touch; false: none, or no angle. A
 * half disc reaches half of the arc's width beyond its ray, and coverage a
 * pixel further than the centres that a shape covers. */
static PEL_NOINLINE_32 bool find_box(const struct pel_surface *surface,
                                     const struct pel_arc_shape *arc,
                                     bool round, struct pel_rect *box)
{
    struct pel_angle_range range;
    const int32_t beyond = round ? (arc->outer - arc->inner) >> 9 : 0;
    *box = surface->clip;
    return pel_angle_range_start(&range, arc, box, beyond + 2, box->y0);
}

static void paint_arc(const struct pel_surface *surface,
                      const struct pel_arc_shape *arc, bool round,
                      const struct pel_paint *paint)
{
    struct pel_smooth_path path;
    struct pel_angles angles;
    struct pel_rect box;
    const bool legal = is_legal(arc);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&arc->center, 1, arc->outer));
    if (!legal || arc->outer <= arc->inner ||
        !pel_angles_set(&angles, arc->from, arc->to) ||
        !find_box(surface, arc, round, &box) ||
        !pel_smooth_path_begin(&path, surface, paint))
        return;
    add_outline(&path, arc, angles, round);
    pel_smooth_path_paint(&path, &box);
}

void pel_smooth_arc(const struct pel_surface *surface,
                    const struct pel_arc_shape *arc,
                    const struct pel_paint *paint)
{
    paint_arc(surface, arc, false, paint);
}

void pel_smooth_arc_round(const struct pel_surface *surface,
                          const struct pel_arc_shape *arc,
                          const struct pel_paint *paint)
{
    paint_arc(surface, arc, true, paint);
}

void pel_smooth_sector(const struct pel_surface *surface,
                       const struct pel_sector_shape *sector,
                       const struct pel_paint *paint)
{
    const struct pel_arc_shape arc = {sector->center, 0, sector->radius,
                                      sector->from, sector->to};
    paint_arc(surface, &arc, false, paint);
}
