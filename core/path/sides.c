#include "sides.h"

/* Half as many where there is no room, twice as many where there was. */
enum pel_status pel_sides_draw(struct pel_sides *s, const struct pel_rect *clip,
                               const struct pel_outline_source *source)
{
    const int32_t end = clip->y1;
    int32_t y = clip->y0, rows = end - y;
    while (y < end && clip->x0 < clip->x1) {
        rows = pel_min(rows, end - y);
        pel_sides_set_rows(s, y, y + rows);
        s->kind->begin(s);
        const enum pel_status status = source->walk(source->shape, s);
        if (status == PEL_OK) {
            s->kind->paint(s);
            y += rows;
            rows *= 2;
        } else if (status == PEL_ERROR_SCRATCH && rows > 1) {
            rows /= 2;
        } else {
            return status;
        }
    }
    return PEL_OK;
}
