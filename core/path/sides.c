#include "sides.h"

/* The next rows: n from y on, inside the clip. */
static PEL_NOINLINE void set_rows(struct pel_sides_painter *p, int32_t y,
                                  int32_t n)
{
    pel_sides_set_rows(&p->sides, y, pel_min(y + n, p->clip->y1));
}

/* Tries half as many rows where there is no room, and goes on with twice as
 * many where there was room for them. All is kept in p, to spare stack. */
enum pel_status pel_sides_draw(struct pel_sides_painter *p,
                               pel_outline_walk *walk, const void *shape)
{
    p->walk = walk;
    p->shape = shape;
    while (p->sides.y0 < p->sides.y1 && p->clip->x0 < p->clip->x1) {
        struct pel_sides *const s = &p->sides;
        s->kind->begin(s);
        const enum pel_status status = p->walk(p->shape, s);
        if (status == PEL_OK) {
            const int32_t times = s->kind->paint(s) ? 2 : 1;
            set_rows(p, s->y1, (s->y1 - s->y0) * times);
        } else if (status == PEL_ERROR_SCRATCH && s->y1 - s->y0 > 1) {
            set_rows(p, s->y0, (s->y1 - s->y0) / 2);
        } else {
            return status;
        }
    }
    return PEL_OK;
}
