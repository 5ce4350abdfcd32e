#include "outline.h"

#if !PEL_SMOOTH_TINY
#include "outline_row.h"
#endif

bool pel_smooth_outline_begin(struct pel_smooth_outline *o,
                              const struct pel_surface *surface,
                              const struct pel_rect *box,
                              const struct pel_paint *paint)
{
    const struct pel_rect *const clip = &surface->clip;
    o->seen = pel_rect_intersect(box, clip);
    o->row = INT32_MAX;
#if !PEL_SMOOTH_TINY
    o->inside = box->x0 >= clip->x0 && box->x1 <= clip->x1;
    o->mirrored &= box->y0 >= clip->y0 && box->y1 <= clip->y1;
    o->mirror_y = box->y0 + box->y1 - 1;
    o->alike = INT32_MIN;
#endif
    return !pel_rect_empty(&o->seen) &&
           pel_smooth_begin(&o->smooth, surface, paint);
}

bool pel_smooth_upright(struct pel_smooth_crossing *c, int32_t y, int64_t from,
                        int64_t to)
{
    const int64_t top = (int64_t)y * 65536;
    from = from > top ? from - top : 0;
    to = to - top < 65536 ? to - top : 65536;
    c->strip.circle = NULL;
    c->strip.near = 0;
    c->strip.far = (int32_t)(to - from);
    return from < to;
}

#if !PEL_SMOOTH_TINY
static void call(void *visitor)
{
    struct pel_smooth_visitor *const v = visitor;
    v->visit(v);
}

void pel_smooth_visit(struct pel_smooth_outline *o, int32_t y,
                      struct pel_smooth_visitor *visitor)
{
    pel_smooth_visit_row(o, y, &visitor->crossing, call, visitor);
}
#endif
