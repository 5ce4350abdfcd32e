#include "angle_range.h"

#include "../base/trig.h"

enum {
    END = 1 << 20, /* px: beyond every pixel */
    QUARTER_TURN = 16384,
    HALF_TURN = 32768,
    FULL_TURN = 65536,
    RAY_LENGTH = 511 /* multiple of the direction: 511 * 32,768 < 2^24 */
};

/* Starts the edge in row y or, below that, its first row. It ends about 2^24
 * sub-pixels from the centre (radii are below 2^23); the row through the centre
 * is not part of it (level_row). */
static PEL_NOINLINE void ray_start(struct pel_ray *r, uint16_t turn,
                                   const struct pel_point *center, int32_t y)
{
    const struct pel_point d = pel_direction(turn);
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

bool pel_angle_range_start(struct pel_angle_range *range,
                           const struct pel_point *center, int32_t from,
                           int32_t to, int32_t y)
{
    if (!pel_angles_set(&range->angles, from, to))
        return false;
    ray_start(&range->from, range->angles.from, center, y);
    ray_start(&range->to, range->angles.to, center, y);
    return true;
}
