#include "outline_line.h"

bool pel_outline_next(struct pel_outline_line *o, int32_t y,
                      struct pel_row *inside)
{
    const struct pel_rect *clip = &o->cut.rows.surface->clip;
    const struct pel_row row = o->row;
    struct pel_row *run = pel_outline_run(o);
    inside->x0 = pel_max(row.x0 + 1, pel_max(o->above.x0, run->x0));
    inside->x1 = pel_min(row.x1 - 1, pel_min(o->above.x1, run->x1));
    o->above = row;
    o->row = *run;
    run->x0 = pel_max(row.x0, clip->x0);
    run->x1 = pel_min(row.x1, clip->x1);
    return y > clip->y0 && y <= clip->y1;
}

void pel_outline_cut(struct pel_outline_line *o, int32_t y)
{
    struct pel_row inside;
    if (pel_outline_next(o, y, &inside))
        o->cut.rows.n =
            pel_cut_hole(o->cut.row, 0, pel_outline_run(o), &inside);
}
