#include "outline_line.h"

bool pel_outline_next(struct pel_outline_line *o, int32_t y,
                      struct pel_span *inside)
{
    const struct pel_rect *clip = &o->cut.spans.surface->clip;
    const struct pel_span span = o->span;
    struct pel_span *run = pel_outline_run(o);
    inside->x0 = pel_max(span.x0 + 1, pel_max(o->above.x0, run->x0));
    inside->x1 = pel_min(span.x1 - 1, pel_min(o->above.x1, run->x1));
    o->above = span;
    o->span = *run;
    run->x0 = pel_max(span.x0, clip->x0);
    run->x1 = pel_min(span.x1, clip->x1);
    return y > clip->y0 && y <= clip->y1;
}

void pel_outline_cut(struct pel_outline_line *o, int32_t y)
{
    struct pel_span inside;
    if (pel_outline_next(o, y, &inside))
        o->cut.spans.n =
            pel_cut_hole(o->cut.span, 0, pel_outline_run(o), &inside);
}
