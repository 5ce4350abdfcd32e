#include "wedge.h"

#include "../base/fixed_trig.h"

enum {
    FAR = 1 << 20, /* px: beyond every pixel */
    QUARTER_TURN = 16384,
    HALF_TURN = 32768,
    FULL_TURN = 65536,
    RAY_LENGTH = 511 /* of a ray in directions: 511 * 32,768 < 2^24 */
};

/* The edge ends about 2^24 sub-pixels from the centre, twice the radius of any
 * shape and more. */
static PEL_NOINLINE void ray_start(struct pel_ray *r,
                                   const struct pel_point *center,
                                   struct pel_point d)
{
    const bool mirrored = d.y > 0;
    const int32_t x = mirrored ? -d.x : d.x;
    struct pel_point a = {mirrored ? -center->x : center->x, center->y};
    struct pel_point b = {a.x + x * RAY_LENGTH, a.y + d.y * RAY_LENGTH};
    const struct pel_point *top = mirrored ? &a : &b;
    const struct pel_point *bottom = mirrored ? &b : &a;
    r->y = pel_first_pixel(top->y);
    r->end = pel_first_pixel(bottom->y);
    if (r->y < r->end)
        pel_edge_start(&r->edge, top, bottom, r->y);
}

/* Past the end of its edge the ray is further away in x than anything that is
 * covered there, on the side to which it points. */
static int32_t beyond(const struct pel_ray *r)
{
    return r->turn > QUARTER_TURN && r->turn < FULL_TURN - QUARTER_TURN ? -FAR
                                                                        : FAR;
}

/* Where the ray divides row y, which lies below or above the centre: the first
 * pixel on the side of larger x. */
static int32_t ray_at(struct pel_ray *r, int32_t y, bool below)
{
    if (below ? r->turn == 0 : r->turn == FULL_TURN)
        return FAR;
    if (below ? r->turn >= HALF_TURN : r->turn <= HALF_TURN)
        return -FAR;
    if (y < r->y || y >= r->end)
        return beyond(r);
    pel_edge_skip(&r->edge, y - r->y);
    r->y = y;
    return below ? -r->edge.x : r->edge.x;
}

/* The row through the centre holds the angles 0 and a half turn alone. */
static void level_row(const struct pel_wedge *w, struct pel_row part[2])
{
    const int32_t from = w->from.turn, to = w->to.turn;
    const int32_t split = pel_first_pixel(w->center->x);
    bool right = from == 0 || from > to;
    bool left = from < to ? from <= HALF_TURN && HALF_TURN < to
                          : from <= HALF_TURN || HALF_TURN < to;
    part[0] = (struct pel_row){left ? -FAR : split, split};
    part[1] = (struct pel_row){split, right ? FAR : split};
}

void pel_wedge_parts(struct pel_wedge *wedge, int32_t y, struct pel_row part[2])
{
    const int32_t v = pel_pixel_center(y) - wedge->center->y;
    struct pel_ray *from = &wedge->from, *to = &wedge->to;
    if (v == 0) {
        level_row(wedge, part);
        return;
    }
    int32_t x0 = ray_at(v > 0 ? to : from, y, v > 0);
    int32_t x1 = ray_at(v > 0 ? from : to, y, v > 0);
    if (from->turn < to->turn) {
        part[0] = (struct pel_row){x0, x1};
        part[1] = (struct pel_row){FAR, FAR};
    } else {
        part[0] = (struct pel_row){-FAR, x1};
        part[1] = (struct pel_row){x0, FAR};
    }
}

bool pel_wedge_start(struct pel_wedge *wedge, const struct pel_point *center,
                     uint16_t from, uint16_t to)
{
    wedge->center = center;
    wedge->from.turn = from;
    wedge->to.turn = to ? to : FULL_TURN;
    ray_start(&wedge->from, center, pel_direction(from));
    ray_start(&wedge->to, center, pel_direction(to));
    return from != to;
}
