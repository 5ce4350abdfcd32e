#include "round_strips.h"

void pel_smooth_strips_start(struct pel_smooth_strips *s,
                             const struct pel_smooth_round *round, int32_t y)
{
    const int32_t above = round->top - y * 256, below = y * 256 - round->bottom;
    pel_smooth_circle_set(&s->circle, round->radius);
    s->at = pel_smooth_arc_at(&s->circle, pel_max(above, below));
}

static void add_strip(struct pel_smooth_strips *s, int32_t near, int32_t far,
                      int32_t at_near, int32_t at_far)
{
    struct pel_smooth_strip *const strip = &s->strip[s->n];
    if (near >= far)
        return;
    s->n++;
    strip->circle = &s->circle;
    strip->near = near * 256;
    strip->far = far * 256;
    strip->at_near = at_near;
    strip->at_far = at_far;
    pel_smooth_strip_set(strip);
}

void pel_smooth_strips_row(struct pel_smooth_strips *s,
                           const struct pel_smooth_round *round, int32_t y)
{
    const int32_t above = round->top - y * 256, below = y * 256 - round->bottom;
    const int32_t radius = round->radius, most = radius * 256;
    s->n = 0;
    if (above > 0) {
        const int32_t near = pel_max(above - 256, 0), at = s->at;
        s->at = near ? pel_smooth_arc_at(&s->circle, near) : most;
        add_strip(s, near, pel_min(above, radius), s->at, at);
    }
    if (below < -pel_max(above, 0))
        add_strip(s, pel_max(above, 0), pel_min(-below, 256), most, most);
    if (below > -256) {
        const int32_t near = pel_max(below, 0), at = near ? s->at : most;
        s->at = pel_smooth_arc_at(&s->circle, below + 256);
        add_strip(s, near, pel_min(below + 256, radius), at, s->at);
    }
}

uint32_t pel_smooth_strips_height(const struct pel_smooth_strips *s)
{
    int32_t height = 0;
    for (int32_t i = 0; i < s->n; i++)
        height += pel_smooth_height(&s->strip[i]);
    return (uint32_t)height;
}

struct pel_span pel_smooth_strips_side(const struct pel_smooth_strips *s,
                                       int32_t center)
{
    struct pel_span side = {INT32_MAX, INT32_MIN};
    for (int32_t i = 0; i < s->n; i++) {
        const struct pel_smooth_strip *const strip = &s->strip[i];
        side.x0 = pel_min(side.x0, pel_smooth_column(center, strip->at_far));
        side.x1 =
            pel_max(side.x1, pel_smooth_column(center, strip->at_near) + 1);
    }
    return side;
}

void pel_smooth_strips_areas(const struct pel_smooth_strips *s, int32_t center,
                             int32_t x, int32_t n, uint16_t *area)
{
    pel_smooth_strip_areas(&s->strip[0], center, x, n, area);
    for (int32_t i = 1; i < s->n; i++) {
        uint16_t more[PEL_SMOOTH_WINDOW];
        pel_smooth_strip_areas(&s->strip[i], center, x, n, more);
        for (int32_t k = 0; k < n; k++)
            area[k] = (uint16_t)(area[k] + more[k]);
    }
}
