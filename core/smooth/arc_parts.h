/* What the files about arcs share: one has the fast way, the other one the way
 * that needs little stack. */
#ifndef PEL_SMOOTH_ARC_PARTS_H
#define PEL_SMOOTH_ARC_PARTS_H

#include "../base/trig.h"
#include "../round/angle_range.h"
#include "line_side.h"
#include "round.h"

/* A point on the ray of a direction, 2^-16 px from the centre. The length of d
 * is 2^15 (1 + e / 2), |e| < 2^-14: products are below 2^23 2^15, then 2^31
 * 2^17. */
static inline struct pel_smooth_place pel_smooth_arc_place_at(
    struct pel_point d, int32_t radius)
{
    const int32_t e = d.x * d.x + d.y * d.y - (1 << 30); /* 2^-30 */
    const int64_t x = pel_product(d.x, radius) >> 7;
    const int64_t y = pel_product(d.y, radius) >> 7;
    return (struct pel_smooth_place){
        (int32_t)(x - (pel_long_product((int32_t)x, e) >> 31)),
        (int32_t)(y - (pel_long_product((int32_t)y, e) >> 31))};
}

/* Sets the quarters of a circle between two angles. Where both lie in one
 * quadrant it goes through that one alone, or around and back to it: five. */
static inline void pel_smooth_arc_set_quarters(struct pel_smooth_circle *circle,
                                               struct pel_angles a)
{
    const int32_t steps = ((a.to >> 14) - (a.from >> 14)) & 3;
    const bool back = (uint16_t)(a.to - a.from) > 16384;
    circle->first = (uint8_t)(a.from >> 14);
    circle->count = (uint8_t)(steps == 0 && back ? 5 : steps + 1);
}

/* Of a half disc, around the middle of an end. */
static inline struct pel_point pel_smooth_arc_half_center(
    const struct pel_point *center, struct pel_smooth_place m)
{
    return (struct pel_point){center->x + ((m.x + 128) >> 8),
                              center->y + ((m.y + 128) >> 8)};
}

static PEL_HOT void pel_smooth_arc_widen(struct pel_rect *box, int32_t x,
                                         int32_t y)
{
    box->x0 = pel_min(box->x0, x);
    box->y0 = pel_min(box->y0, y);
    box->x1 = pel_max(box->x1, x);
    box->y1 = pel_max(box->y1, y);
}

/* The axes that a curve passes. */
static inline void pel_smooth_arc_add_axes(struct pel_rect *box,
                                           const struct pel_smooth_curve *curve)
{
    const struct pel_point c = curve->center;
    const int32_t r = curve->circle.radius, first = curve->circle.first;
    for (int32_t k = first + 1; k < first + curve->circle.count; k++) {
        const int32_t way = k & 2 ? -r : r;
        pel_smooth_arc_widen(box, c.x + (k & 1 ? 0 : way),
                             c.y + (k & 1 ? way : 0));
    }
}

/* The pixels around that, and a little more. */
static inline struct pel_rect pel_smooth_arc_pixels_of(
    const struct pel_rect *box, int32_t more)
{
    return (struct pel_rect){
        pel_pixel_of(box->x0 - more), pel_pixel_of(box->y0 - more),
        pel_pixel_of(box->x1 + more) + 1, pel_pixel_of(box->y1 + more) + 1};
}

static inline bool pel_smooth_arc_is_legal(const struct pel_arc_shape *arc)
{
    const bool legal = pel_point_legal(arc->center) &&
                       pel_radius_legal(arc->inner) &&
                       pel_radius_legal(arc->outer);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&arc->center, 1, arc->outer));
    return legal;
}

#endif
