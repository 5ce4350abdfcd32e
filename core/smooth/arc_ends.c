#include "arc_ends.h"

#include "../base/trig.h"
#include "../round/angle_range.h"

/* 2^-16 px from the beginning. The length of d is 2^15 (1 + e / 2), |e| <
 * 2^-14: products are below 2^23 2^15, then 2^31 2^17. */
struct pel_smooth_place pel_smooth_place_at(struct pel_point d, int32_t radius)
{
    const int32_t e = d.x * d.x + d.y * d.y - (1 << 30); /* 2^-30 */
    const int64_t x = pel_product(d.x, radius) >> 7;
    const int64_t y = pel_product(d.y, radius) >> 7;
    return (struct pel_smooth_place){
        (int32_t)(x - (pel_long_product((int32_t)x, e) >> 31)),
        (int32_t)(y - (pel_long_product((int32_t)y, e) >> 31))};
}

struct pel_point pel_smooth_end_center(const struct pel_arc_shape *arc,
                                       uint16_t angle)
{
    const struct pel_smooth_place m = pel_smooth_place_at(
        pel_direction(angle), (arc->inner + arc->outer) >> 1);
    return (struct pel_point){arc->center.x + ((m.x + 128) >> 8),
                              arc->center.y + ((m.y + 128) >> 8)};
}

/* The pixels from a to b, and up to 2 sub-pixels around them. */
static void span_between(int32_t center, int32_t a, int32_t b, int32_t *from,
                         int32_t *to)
{
    *from = pel_pixel_of(center + (pel_min(a, b) >> 8) - 2);
    *to = pel_pixel_of(center + (pel_max(a, b) >> 8) + 3) + 1;
}

/* To the next row, 2^-15; along a row as it is. Small CPUs have a division
 * without signs already. */
static int32_t slope_of(struct pel_point d)
{
    const uint32_t x = (uint32_t)pel_magnitude(d.x) * 32768;
    const int32_t slope = (int32_t)(d.y ? x / (uint32_t)pel_magnitude(d.y) : x);
    return (d.x < 0) == (d.y < 0) ? slope : -slope;
}

static void set_ray(struct pel_smooth_end *e, const struct pel_arc_shape *arc,
                    struct pel_point d)
{
    const struct pel_smooth_place a =
        pel_smooth_place_at(d, pel_max(arc->inner - 256, 0));
    const struct pel_smooth_place b = pel_smooth_place_at(d, arc->outer);
    span_between(arc->center.x, a.x, b.x, &e->ray.x0, &e->ray.x1);
    span_between(arc->center.y, a.y, b.y, &e->ray.y0, &e->ray.y1);
    e->box = e->ray;
    e->slope = slope_of(d);
    e->shift = d.y ? 15 : 0;
    e->right = d.x >= 0;
    e->up = d.y < 0;
}

static void set_disc(struct pel_smooth_end *e, struct pel_point center,
                     int32_t radius)
{
    const int32_t r = radius * 256;
    span_between(center.x, -r, r, &e->disc.x0, &e->disc.x1);
    span_between(center.y, -r, r, &e->disc.y0, &e->disc.y1);
    e->box.x0 = pel_min(e->box.x0, e->disc.x0);
    e->box.y0 = pel_min(e->box.y0, e->disc.y0);
    e->box.x1 = pel_max(e->box.x1, e->disc.x1);
    e->box.y1 = pel_max(e->box.y1, e->disc.y1);
}

static void set_end(struct pel_smooth_end *e, const struct pel_arc_shape *arc,
                    uint16_t angle, bool round)
{
    set_ray(e, arc, pel_direction(angle));
    e->disc = (struct pel_rect){0, 0, 0, 0};
    if (round)
        set_disc(e, pel_smooth_end_center(arc, angle),
                 (arc->outer - arc->inner) >> 1);
}

void pel_smooth_ends_set(struct pel_smooth_ends *ends,
                         const struct pel_arc_shape *arc, bool round)
{
    const uint16_t from = (uint16_t)arc->from, to = (uint16_t)arc->to;
    ends->center = arc->center;
    ends->top = (uint16_t)(49151 - from) < (uint16_t)(to - from);
    set_end(&ends->end[0], arc, from, round);
    set_end(&ends->end[1], arc, to, round);
}

/* Where a ray is at a height below the centre, off by less than 2^-15 of it;
 * one that is flat or far away is no further than 2^30. */
static int32_t ray_at(const struct pel_smooth_ends *ends,
                      const struct pel_smooth_end *e, int32_t v)
{
    const int64_t x = pel_long_product(e->slope, v) >> e->shift;
    const int32_t limit = 1 << 30;
    return x < -limit  ? -limit
           : x > limit ? limit
                       : ends->center.x + (int32_t)x;
}

static bool ray_columns(const struct pel_smooth_ends *ends,
                        const struct pel_smooth_end *e, int32_t y,
                        struct pel_span *columns)
{
    const int32_t v = y * 256 - ends->center.y;
    const int32_t off = (pel_magnitude(v) >> 15) + 3;
    if (y < e->ray.y0 || y >= e->ray.y1)
        return false;
    const int32_t a = ray_at(ends, e, v), b = ray_at(ends, e, v + 256);
    columns->x0 = pel_pixel_of(pel_min(a, b) - off);
    columns->x1 = pel_pixel_of(pel_max(a, b) + off) + 1;
    columns->x0 = pel_max(e->ray.x0, pel_min(columns->x0, e->ray.x1 - 1));
    columns->x1 = pel_min(e->ray.x1, pel_max(columns->x1, e->ray.x0 + 1));
    return true;
}

bool pel_smooth_end_columns(const struct pel_smooth_ends *ends, int i,
                            int32_t y, struct pel_span *columns)
{
    const struct pel_smooth_end *const e = &ends->end[i];
    const bool near = ray_columns(ends, e, y, columns);
    if (y < e->disc.y0 || y >= e->disc.y1)
        return near;
    columns->x0 = near ? pel_min(columns->x0, e->disc.x0) : e->disc.x0;
    columns->x1 = near ? pel_max(columns->x1, e->disc.x1) : e->disc.x1;
    return true;
}

/* A row with columns near an end. */
struct near_row {
    struct pel_span columns[2]; /* empty: none */
    bool near[2];
};

/* Is column x near to end i? */
static bool is_near(const struct near_row *n, int i, int32_t x)
{
    return n->near[i] && x >= n->columns[i].x0 && x < n->columns[i].x1;
}

/* Has the way from the top to column x, which is near to no end, passed end i?
 */
static bool has_passed(const struct pel_smooth_ends *ends,
                       const struct near_row *n, int i, int32_t y, int32_t x)
{
    const struct pel_smooth_end *const e = &ends->end[i];
    const bool right = x >= pel_first_pixel(ends->center.x);
    if (right != e->right)
        return false;
    if (y < e->ray.y0 || y >= e->ray.y1)
        return y >= e->ray.y1;
    return e->up == (right ? x >= n->columns[i].x1 : x < n->columns[i].x0);
}

static bool is_inside(const struct pel_smooth_ends *ends,
                      const struct near_row *n, int32_t y, int32_t x)
{
    return !is_near(n, 0, x) && !is_near(n, 1, x) &&
           (ends->top ^ has_passed(ends, n, 0, y, x) ^
            has_passed(ends, n, 1, y, x));
}

/* Where another part of the row may begin, right of x. */
static int32_t end_of_part(const struct pel_smooth_ends *ends,
                           const struct near_row *n, int32_t x)
{
    const int32_t axis = pel_first_pixel(ends->center.x);
    int32_t end = x < axis ? axis : INT32_MAX;
    for (int i = 0; i < 2; i++) {
        if (n->near[i] && x < n->columns[i].x0)
            end = pel_min(end, n->columns[i].x0);
        if (is_near(n, i, x))
            end = pel_min(end, n->columns[i].x1);
    }
    return end;
}

void pel_smooth_ends_paint(const struct pel_smooth_ends *ends,
                           const struct pel_smooth *smooth,
                           const struct pel_smooth_row *row)
{
    const struct pel_rect *const all = &smooth->target->clip;
    struct pel_rect clip = *all;
    struct near_row n;
    for (int i = 0; i < 2; i++)
        n.near[i] = pel_smooth_end_columns(ends, i, row->y, &n.columns[i]);
    for (; clip.x0 < all->x1; clip.x0 = clip.x1) {
        clip.x1 = pel_min(end_of_part(ends, &n, clip.x0), all->x1);
        if (is_inside(ends, &n, row->y, clip.x0))
            pel_smooth_paint_clipped(smooth, row, &clip);
    }
}

enum pel_smooth_share pel_smooth_ends_share(const struct pel_smooth_ends *ends,
                                            const struct pel_rect *part)
{
    const int32_t axis = pel_first_pixel(ends->center.x);
    const bool left = part->x0<axis, right = part->x1> axis;
    bool side[2] = {ends->top, ends->top};
    for (int i = 0; i < 2; i++) {
        const struct pel_smooth_end *const e = &ends->end[i];
        const bool touched = part->x0 < e->box.x1 && part->x1 > e->box.x0;
        if (part->y0 < e->box.y1 && part->y1 > e->box.y0 &&
            (touched || (e->right ? right : left)))
            return PEL_SMOOTH_NEAR;
        side[e->right] ^= part->y0 >= e->ray.y1;
    }
    if (left && right && side[0] != side[1])
        return PEL_SMOOTH_NEAR;
    return side[right] ? PEL_SMOOTH_ALL : PEL_SMOOTH_NONE;
}
