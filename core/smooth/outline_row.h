/* What a curve has in a row, for the one file that asks for it: which one
 * depends on how core is compiled. */
#ifndef PEL_SMOOTH_OUTLINE_ROW_H
#define PEL_SMOOTH_OUTLINE_ROW_H

#include "outline.h"

/* Where the circle is at the top of a row; between the corners of a rectangle
 * as far away as it can be. */
static PEL_SMOOTH_APART int32_t
pel_smooth_curve_at(const struct pel_smooth_curve *curve, int32_t y)
{
    const int32_t above = curve->center.y - y * 256;
    const int32_t distance = pel_max(above, -above - curve->spread.y);
    return distance > 0 ? pel_smooth_arc_at(&curve->circle, distance, false)
                        : pel_smooth_reach(&curve->circle);
}

/* May the curve be in a row? */
static inline bool pel_smooth_curve_in(const struct pel_smooth_curve *curve,
                                       int32_t y)
{
    const int32_t down = y * 256 - curve->center.y;
    const int32_t radius = curve->circle.radius;
    return down > -radius - 256 && down < radius + curve->spread.y;
}

/* What its kth quarter has in that row as a whole circle, but where it is
 * there: false where it has nothing. */
static PEL_SMOOTH_APART bool pel_smooth_find_quarter(
    const struct pel_smooth_curve *curve, int32_t y, int32_t k,
    struct pel_smooth_crossing *c)
{
    struct pel_smooth_strip *const s = &c->strip;
    const int32_t quadrant = (curve->circle.first + k) & 3;
    const int32_t down = y * 256 - curve->center.y;
    const bool below = quadrant < 2;
    const int32_t near = below ? down - curve->spread.y : -256 - down;
    const int32_t far = pel_min(near + 256, curve->circle.radius);
    if (near >= far || far <= 0)
        return false;
    s->circle = &curve->circle;
    s->near = pel_max(near, 0) * 256;
    s->far = far * 256;
    c->below = below;
    c->other = -1;
    c->left = quadrant == 1 || quadrant == 2;
    c->rising = c->left != curve->circle.hole;
    c->center = c->left ? -curve->center.x : curve->center.x + curve->spread.x;
    return true;
}

/* Where it is, from where its circle is at the ends of the row. Places a unit
 * outside of the circle do not matter. */
static inline void pel_smooth_place_quarter(struct pel_smooth_crossing *c,
                                            const int32_t at[2])
{
    struct pel_smooth_strip *const s = &c->strip;
    s->at_near = s->near > 0 ? at[!c->below] : pel_smooth_reach(s->circle);
    s->at_far = pel_min(at[c->below], s->at_near);
}

#endif
