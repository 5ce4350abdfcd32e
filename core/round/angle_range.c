#include "angle_range.h"

#include "../base/trig.h"

enum {
    END = 1 << 20, /* px: beyond every pixel */
    QUARTER_TURN = 16384,
    HALF_TURN = 32768,
    FULL_TURN = 65536,
    RAY_LENGTH = 511 /* multiple of the direction: 511 * 32,768 < 2^24 */
};

static void set_direction(struct pel_ray *r, uint16_t turn)
{
    const struct pel_point d = pel_direction(turn);
    r->edge.x = d.x;
    r->edge.m = d.y;
}

static struct pel_point direction_of(const struct pel_ray *r)
{
    return (struct pel_point){r->edge.x, r->edge.m};
}

/* Starts the edge in row y or, below that, its first row. It ends about 2^24
 * sub-pixels from the centre (radii are below 2^23); the row through the centre
 * is not part of it (level_row). */
static PEL_NOINLINE void ray_start(struct pel_ray *r,
                                   const struct pel_point *center, int32_t y)
{
    const struct pel_point d = direction_of(r);
    const bool mirrored = d.y > 0;
    const int32_t x = mirrored ? -d.x : d.x;
    const struct pel_point a = {mirrored ? -center->x : center->x, center->y};
    const struct pel_point b = {a.x + x * RAY_LENGTH, a.y + d.y * RAY_LENGTH};
    const int32_t at_center = pel_first_pixel(center->y + mirrored);
    r->bound = pel_first_pixel(b.y);
    if (mirrored) {
        y = pel_max(y, at_center);
        if (y < r->bound)
            pel_edge_start(&r->edge, &a, &b, y);
    } else {
        y = pel_max(y, r->bound);
        if (y < at_center)
            pel_edge_start(&r->edge, &b, &a, y);
    }
}

/* In rows past the end of its edge a ray lies beyond every covered pixel, on
 * the side to which it points. */
static int32_t beyond(int32_t turn)
{
    return turn > QUARTER_TURN && turn < FULL_TURN - QUARTER_TURN ? -END : END;
}

/* The first pixel right of the ray in row y, which is below or above the
 * centre. A pixel on the ray is right of it above, left of it below. */
static int32_t ray_at(struct pel_ray *r, int32_t turn, int32_t y, bool below)
{
    if (below ? turn == 0 : turn == FULL_TURN)
        return END;
    if (below ? turn >= HALF_TURN : turn <= HALF_TURN)
        return -END;
    if ((y < r->bound) != below)
        return beyond(turn);
    const int32_t x = r->edge.x;
    pel_edge_next(&r->edge);
    return below ? -x : x;
}

/* An end of 0 is a full turn. */
static int32_t end_of(struct pel_angles angles)
{
    return angles.to ? angles.to : FULL_TURN;
}

static bool holds(struct pel_angles angles, uint16_t turn)
{
    const uint16_t size = (uint16_t)(angles.to - angles.from);
    return size == 0 || (uint16_t)(turn - angles.from) < size;
}

/* The pixels of the row through the centre have the angle 0 or half a turn. */
static void level_row(struct pel_angles angles, int32_t split,
                      struct pel_span span[2])
{
    span[0] = (struct pel_span){holds(angles, HALF_TURN) ? -END : split, split};
    span[1] = (struct pel_span){split, holds(angles, 0) ? END : split};
}

void pel_angle_range_spans(struct pel_angle_range *range,
                           const struct pel_point *center, int32_t y,
                           struct pel_span span[2])
{
    const int32_t v = pel_pixel_center(y) - center->y;
    const int32_t from = range->angles.from, to = end_of(range->angles);
    if (v == 0) {
        level_row(range->angles, pel_first_pixel(center->x), span);
        return;
    }
    const int32_t first = ray_at(&range->from, from, y, v > 0);
    const int32_t last = ray_at(&range->to, to, y, v > 0);
    const int32_t x0 = v > 0 ? last : first, x1 = v > 0 ? first : last;
    if (from < to) {
        span[0] = (struct pel_span){x0, x1};
        span[1] = (struct pel_span){END, END};
    } else {
        span[0] = (struct pel_span){-END, x1};
        span[1] = (struct pel_span){x0, END};
    }
}

/* The part of a ray's direction along the axis that has the angle `turn`. */
static int32_t part_along(const struct pel_ray *r, uint16_t turn)
{
    const struct pel_point d = direction_of(r);
    const int32_t part = turn & QUARTER_TURN ? d.y : d.x;
    return turn & HALF_TURN ? -part : part;
}

/* How far an arc reaches along an axis: as far as the outer circle where the
 * range holds the axis; elsewhere as the end that is nearer to it, at the outer
 * radius or, pointing away, at the inner one. Radii are rounded to whole px, so
 * that products are below 2^31. A direction is up to 3/4 of 2^-15 of its length
 * too short or too long, and a shift drops less than a sub-pixel. */
static PEL_NOINLINE int32_t reach(const struct pel_arc_shape *arc,
                                  const struct pel_angle_range *range,
                                  uint16_t turn)
{
    int32_t part = PEL_DIRECTION_ONE;
    if (!holds(range->angles, turn))
        part = pel_max(part_along(&range->from, turn),
                       part_along(&range->to, turn));
    const int32_t radius = part > 0 ? (arc->outer + 255) >> 8 : arc->inner >> 8;
    return (part * radius >> 7) + (arc->outer >> 15) + 2;
}

static PEL_NOINLINE void narrow(struct pel_rect *r,
                                const struct pel_arc_shape *arc,
                                const struct pel_angle_range *range,
                                int32_t edge)
{
    int32_t end = arc->center.x - reach(arc, range, HALF_TURN);
    r->x0 = pel_max(r->x0, pel_first_pixel(end) - edge);
    end = arc->center.x + reach(arc, range, 0);
    r->x1 = pel_min(r->x1, pel_pixel_of(end + 128) + edge);
    end = arc->center.y - reach(arc, range, HALF_TURN + QUARTER_TURN);
    r->y0 = pel_max(r->y0, pel_first_pixel(end) - edge);
    end = arc->center.y + reach(arc, range, QUARTER_TURN);
    r->y1 = pel_min(r->y1, pel_pixel_of(end + 128) + edge);
}

bool pel_angle_range_start(struct pel_angle_range *range,
                           const struct pel_arc_shape *arc,
                           struct pel_rect *visible, int32_t edge, int32_t y)
{
    if (!pel_angles_set(&range->angles, arc->from, arc->to))
        return false;
    set_direction(&range->from, range->angles.from);
    set_direction(&range->to, range->angles.to);
    narrow(visible, arc, range, edge);
    y = pel_max(y, visible->y0 - edge);
    ray_start(&range->from, &arc->center, y);
    ray_start(&range->to, &arc->center, y);
    return !pel_rect_empty(visible);
}
