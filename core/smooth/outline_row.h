/* The sides of an outline in a row, for the one file that asks for them: which
 * one depends on how core is compiled. */
#ifndef PEL_SMOOTH_OUTLINE_ROW_H
#define PEL_SMOOTH_OUTLINE_ROW_H

#include "outline.h"

/* Where the circle is at the top of a row; between the corners of a rectangle
 * as far away as it can be. */
static PEL_SMOOTH_APART int32_t
pel_smooth_curve_at(const struct pel_smooth_outline *o,
                    const struct pel_smooth_curve *curve, int32_t y)
{
    const int32_t above = curve->center.y - y * 256;
    const int32_t distance = pel_max(above, -above - o->spread.y);
    return distance > 0 ? pel_smooth_arc_at(&curve->circle, distance, false)
                        : curve->circle.reach;
}

/* The quarters of a curve that may be in a row: for little code, all. */
static inline int32_t pel_smooth_quarters(const struct pel_smooth_outline *o,
                                          const struct pel_smooth_curve *curve,
                                          int32_t y)
{
    const int32_t down = y * 256 - curve->center.y;
    const int32_t radius = curve->circle.radius;
    return PEL_SMALL_CODE ||
                   (down > -radius - 256 && down < radius + o->spread.y)
               ? curve->circle.count
               : 0;
}

/* On to row y; -1 where a curve is not there. */
static PEL_SMOOTH_APART void pel_smooth_go_to(struct pel_smooth_outline *o,
                                              int32_t y)
{
    struct pel_smooth_curve *const end = o->curve + o->curves;
    for (struct pel_smooth_curve *c = o->curve; c < end; c++) {
        c->at[0] = o->row == y - 1 ? c->at[1] : -1;
        c->at[1] = -1;
        if (pel_smooth_quarters(o, c, y) == 0)
            continue;
        if (c->at[0] < 0)
            c->at[0] = pel_smooth_curve_at(o, c, y);
        c->at[1] = pel_smooth_curve_at(o, c, y + 1);
    }
    o->row = y;
}

/* What the kth quarter of curve i has in that row: false where it has nothing.
 * Places a unit outside of the circle do not matter. */
static PEL_SMOOTH_APART bool pel_smooth_find_quarter(
    const struct pel_smooth_outline *o, int32_t i, int32_t k,
    struct pel_smooth_crossing *c)
{
    const struct pel_smooth_curve *const curve = &o->curve[i];
    struct pel_smooth_strip *const s = &c->strip;
    const int32_t quadrant = (curve->circle.first + k) & 3;
    const int32_t down = o->row * 256 - curve->center.y;
    const bool below = quadrant < 2;
    const int32_t near = below ? down - o->spread.y : -256 - down;
    const int32_t far = pel_min(near + 256, curve->circle.radius);
    if (near >= far || far <= 0)
        return false;
    s->circle = &curve->circle;
    s->near = pel_max(near, 0) * 256;
    s->far = far * 256;
    s->at_near = near > 0 ? curve->at[!below] : curve->circle.reach;
    s->at_far = pel_min(curve->at[below], s->at_near);
    c->below = below;
    c->other = -1;
    c->left = quadrant == 1 || quadrant == 2;
    c->rising = c->left != curve->circle.hole;
    c->center = c->left ? -curve->center.x : curve->center.x + o->spread.x;
    return !o->sides || !o->sides->cut ||
           o->sides->cut(o, i, k, quadrant & 1, s);
}

/* Takes the crossing that is set. */
typedef void pel_smooth_visit_function(void *visitor);

/* All sides of row y. They are found in functions that have returned when they
 * are visited, for little stack. */
static PEL_ALWAYS_INLINE void pel_smooth_visit_row(
    struct pel_smooth_outline *o, int32_t y, struct pel_smooth_crossing *c,
    pel_smooth_visit_function *visit, void *visitor)
{
    if (o->row != y)
        pel_smooth_go_to(o, y);
    for (int32_t i = 0; i < o->curves; i++)
        for (int32_t k = pel_smooth_quarters(o, &o->curve[i], y) - 1; k >= 0;
             k--)
            if (pel_smooth_find_quarter(o, i, k, c))
                visit(visitor);
    for (int32_t i = 0; i < o->count; i++) {
        c->other = (int8_t)i;
        if (o->sides->other(o, y, i, c))
            visit(visitor);
    }
}

#endif
