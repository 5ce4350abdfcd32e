#include "round.h"

/* The pixels of a curve, and the column left of what it covers: as the mirror
 * image of one on the right it may be a pixel of coverage 0 that is read and
 * stored. */
static struct pel_rect box_of(const struct pel_smooth_curve *curve,
                              int32_t width)
{
    const struct pel_point c = curve->center,
                           far = {c.x + curve->spread.x, c.y + curve->spread.y};
    const int32_t height = curve->circle.radius;
    return (struct pel_rect){
        pel_pixel_of(c.x - width - 1), pel_pixel_of(c.y - height),
        pel_pixel_of(far.x + width) + 1, pel_pixel_of(far.y + height + 255)};
}

static void set_curve(const struct pel_smooth_round *r,
                      struct pel_smooth_curve *curve)
{
    curve->center = r->center;
    curve->spread = r->spread;
}

#if PEL_SMOOTH_TINY
bool pel_smooth_round_curve(const struct pel_smooth_short_outline *round,
                            int32_t i, struct pel_smooth_curve *curve)
{
    const struct pel_smooth_round *const r = (const void *)round;
    PEL_CAST(void, i);
    pel_smooth_circle_begin(&curve->circle, r->radius);
    curve->circle.of.inverse = r->inverse;
    set_curve(r, curve);
    return true;
}

bool pel_smooth_curve_begin(struct pel_smooth_short_outline *t,
                            const struct pel_smooth_curve *curve, int32_t reach)
{
    const struct pel_rect box = box_of(curve, reach);
    return pel_smooth_short_outline_begin(t, &box);
}

bool pel_smooth_round_begin(struct pel_smooth_round *r)
{
    struct pel_smooth_curve curve;
    pel_smooth_circle_set(&curve.circle, r->radius);
    r->inverse = curve.circle.of.inverse;
    set_curve(r, &curve);
    return pel_smooth_curve_begin(&r->outline, &curve, r->radius);
}
#else
bool pel_smooth_curve_begin(struct pel_smooth_outline *o,
                            struct pel_smooth_curve *curve, int32_t reach)
{
    const struct pel_rect box = box_of(curve, reach);
    o->curve = curve;
    o->curves = 1;
    o->sides = NULL;
    o->count = 0;
    o->mirror_from = INT32_MIN;
    return pel_smooth_outline_begin(o, &box);
}

bool pel_smooth_round_begin(struct pel_smooth_round *r)
{
    pel_smooth_circle_set(&r->curve->circle, r->radius);
    set_curve(r, r->curve);
    return pel_smooth_curve_begin(&r->outline, r->curve, r->radius);
}

void pel_smooth_round_cut(struct pel_smooth_round *r, int32_t radius)
{
    if (radius == 0)
        return;
    r->outline.curves = 2;
    pel_smooth_circle_set(&r->curve[1].circle, radius);
    r->curve[1].circle.hole = true;
    set_curve(r, &r->curve[1]);
}
#endif
