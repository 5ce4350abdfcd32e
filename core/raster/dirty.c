#include "dirty.h"

static void dirty_fill(const struct pel_paint *paint,
                       const struct pel_spans *spans)
{
    struct pel_dirty *d = (struct pel_dirty *)(uintptr_t)paint;
    struct pel_rect *b = &d->box;
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, y += spans->step) {
        const struct pel_span *span = &spans->span[i];
        const struct pel_rect row = {span->x0, y, span->x1, y + 1};
        if (!pel_rect_empty(&row))
            *b = pel_rect_empty(b) ? row : pel_rect_join(b, &row);
    }
    if (d->inner)
        d->inner->fill(d->inner, spans);
}

void pel_dirty_begin(struct pel_dirty *dirty, const struct pel_paint *paint)
{
    dirty->paint = (struct pel_paint){.fill = dirty_fill};
    dirty->inner = paint;
    dirty->box = (struct pel_rect){0, 0, 0, 0};
}
