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

static void set_curve(const struct pel_smooth_round *r, int32_t i,
                      struct pel_smooth_curve *curve)
{
    curve->center = r->center;
    curve->spread = r->spread;
    curve->circle.hole = i > 0;
}

#if PEL_SMOOTH_TINY
bool pel_smooth_round_curve(const struct pel_smooth_short_outline *round,
                            int32_t i, struct pel_smooth_curve *curve)
{
    const struct pel_smooth_round *const r = (const void *)round;
    pel_smooth_circle_begin(&curve->circle, r->radius[i]);
    curve->circle.of.inverse = r->inverse[i];
    set_curve(r, i, curve);
    return true;
}

const struct pel_smooth_kind pel_smooth_discs = {
    .curves = 1, .curve = pel_smooth_round_curve};
const struct pel_smooth_kind pel_smooth_rings = {
    .curves = 2, .curve = pel_smooth_round_curve};

bool pel_smooth_curve_begin(struct pel_smooth_short_outline *t,
                            const struct pel_smooth_curve *curve, int32_t reach)
{
    const struct pel_rect box = box_of(curve, reach);
    return pel_smooth_short_outline_begin(t, &box);
}

bool pel_smooth_round_begin(struct pel_smooth_round *r)
{
    struct pel_smooth_curve curve;
    for (int32_t i = 1; i >= 0; i--) {
        pel_smooth_circle_set(&curve.circle, r->radius[i]);
        r->inverse[i] = curve.circle.of.inverse;
    }
    set_curve(r, 0, &curve);
    return pel_smooth_curve_begin(&r->outline, &curve, r->radius[0]);
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
    for (int32_t i = r->radius[1] > 0; i >= 0; i--) {
        pel_smooth_circle_set(&r->curve[i].circle, r->radius[i]);
        set_curve(r, i, &r->curve[i]);
    }
    if (!pel_smooth_curve_begin(&r->outline, r->curve, r->radius[0]))
        return false;
    r->outline.curves = r->radius[1] > 0 ? 2 : 1;
    return true;
}
#endif
