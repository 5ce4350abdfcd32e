#include "sides.h"

/* Tries half as many rows where there is no room, and goes on with twice as
 * many where there was room for them. During calls the rows are kept in s
 * alone, to spare stack. */
enum pel_status pel_sides_draw(struct pel_sides *s, const struct pel_rect *clip,
                               const struct pel_outline_source *source)
{
    int32_t y = clip->y0, end = clip->y1;
    while (y < clip->y1 && clip->x0 < clip->x1) {
        pel_sides_set_rows(s, y, pel_min(end, clip->y1));
        s->kind->begin(s);
        const enum pel_status status = source->walk(source->shape, s);
        if (status == PEL_OK) {
            const int32_t times = s->kind->paint(s) ? 2 : 1;
            y = s->y1;
            end = y + (y - s->y0) * times;
        } else if (status == PEL_ERROR_SCRATCH && s->y1 - s->y0 > 1) {
            y = s->y0;
            end = y + (s->y1 - y) / 2;
        } else {
            return status;
        }
    }
    return PEL_OK;
}
