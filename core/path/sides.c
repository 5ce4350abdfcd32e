#include "sides.h"

static void set_rows(struct pel_sides *s, int32_t y, int32_t rows)
{
    s->y0 = y;
    s->y1 = y + rows;
    s->top = PEL_PX(y);
    s->bottom = PEL_PX(y + rows);
    s->kind->begin(s);
}

/* Half as many where there is no room, twice as many where there was. */
enum pel_status pel_sides_draw(struct pel_sides *s, const struct pel_rect *clip,
                               const struct pel_outline_source *source)
{
    const int32_t end = clip->y1;
    int32_t y = clip->y0, rows = end - y;
    while (y < end && clip->x0 < clip->x1) {
        rows = pel_min(rows, end - y);
        set_rows(s, y, rows);
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
