#include "wedge.h"

#include "../base/trig.h"

enum {
    FAR = 1 << 20, /* px: beyond every pixel */
    QUARTER_TURN = 16384,
    HALF_TURN = 32768,
    FULL_TURN = 65536,
    RAY_LENGTH = 511 /* of a ray in directions: 511 * 32,768 < 2^24 */
};

/* The edge ends about 2^24 sub-pixels from the centre, twice the radius of any
 * shape and more. Below the centre the row through it is not walked. */
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

/* Past the end of its edge the ray is further away in x than anything that is
 * covered there, on the side to which it points. */
static int32_t beyond(int32_t turn)
{
    return turn > QUARTER_TURN && turn < FULL_TURN - QUARTER_TURN ? -FAR : FAR;
}

/* Where the ray divides row y, which lies below or above the centre: the first
 * pixel on the side of larger x. */
static int32_t ray_at(struct pel_ray *r, int32_t turn, int32_t y, bool below)
{
    if (below ? turn == 0 : turn == FULL_TURN)
        return FAR;
    if (below ? turn >= HALF_TURN : turn <= HALF_TURN)
        return -FAR;
    if ((y < r->bound) != below)
        return beyond(turn);
    const int32_t x = r->edge.x;
    pel_edge_next(&r->edge);
    return below ? -x : x;
}

/* The end of a range that ends at 0 is a full turn. */
static int32_t end_of(struct pel_angles angles)
{
    return angles.to ? angles.to : FULL_TURN;
}

/* The row through the centre holds the angles 0 and a half turn alone. */
static void level_row(struct pel_angles angles, int32_t split,
                      struct pel_span part[2])
{
    const int32_t from = angles.from, to = end_of(angles);
    bool right = from == 0 || from > to;
    bool left = from < to ? from <= HALF_TURN && HALF_TURN < to
                          : from <= HALF_TURN || HALF_TURN < to;
    part[0] = (struct pel_span){left ? -FAR : split, split};
    part[1] = (struct pel_span){split, right ? FAR : split};
}

void pel_wedge_parts(struct pel_wedge *wedge, const struct pel_point *center,
                     int32_t y, struct pel_span part[2])
{
    const int32_t v = pel_pixel_center(y) - center->y;
    const int32_t from = wedge->angles.from, to = end_of(wedge->angles);
    if (v == 0) {
        level_row(wedge->angles, pel_first_pixel(center->x), part);
        return;
    }
    const int32_t first = ray_at(&wedge->from, from, y, v > 0);
    const int32_t last = ray_at(&wedge->to, to, y, v > 0);
    const int32_t x0 = v > 0 ? last : first, x1 = v > 0 ? first : last;
    if (from < to) {
        part[0] = (struct pel_span){x0, x1};
        part[1] = (struct pel_span){FAR, FAR};
    } else {
        part[0] = (struct pel_span){-FAR, x1};
        part[1] = (struct pel_span){x0, FAR};
    }
}

bool pel_wedge_start(struct pel_wedge *wedge, const struct pel_point *center,
                     struct pel_angles angles, int32_t y)
{
    wedge->angles = angles;
    ray_start(&wedge->from, angles.from, center, y);
    ray_start(&wedge->to, angles.to, center, y);
    return angles.from != angles.to;
}
