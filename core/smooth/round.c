#include "round.h"

static void set_circle(struct pel_smooth_bow *b, struct pel_point center,
                       int32_t radius, bool hole)
{
    b->center = center;
    b->first = 0;
    b->count = 4;
    b->hole = hole;
    pel_smooth_bow_set(b, radius);
}

void pel_smooth_round(const struct pel_surface *surface,
                      const struct pel_smooth_round *round,
                      const struct pel_paint *paint)
{
    const struct pel_point c = round->center,
                           far = {c.x + round->spread.x, c.y + round->spread.y};
    const int32_t r = round->outer;
    struct pel_smooth_bow bow[2];
    struct pel_smooth_outline o;
    set_circle(&bow[0], c, r, false);
    set_circle(&bow[1], c, round->inner, true);
    if (round->oval) {
        bow[0].circle.oval = round->oval;
        bow[0].circle.reach = round->oval->reach;
    }
    o.spread = round->spread;
    o.bow = bow;
    o.bows = round->inner > 0 ? 2 : 1;
    o.cut = NULL;
    o.other = round->other;
    o.others = o.other ? 2 : 0;
    o.twins = ((c.y + far.y) & 255) == 0;
    /* With the column on the left that a shape just touches: as image of one on
     * the right it is a pixel of coverage 0, which is read and stored. */
    const int32_t width = bow[0].circle.reach >> 8;
    const struct pel_rect box = {
        pel_pixel_of(c.x - width - 1), pel_pixel_of(c.y - r),
        pel_pixel_of(far.x + width) + 1, pel_pixel_of(far.y + r + 255)};
    if (pel_smooth_outline_begin(&o, surface, &box, paint))
        pel_smooth_outline_paint(&o);
}
