#include "blend565.h"

#if PEL_VECTORS

void pel_blend565_rows(const struct pel_rows *rows, pel_color color)
{
    const struct pel_blend565 b =
        pel_blend565_make(rows->surface->format, color);
    const struct pel_row *row = rows->row;
    int32_t y = rows->y;
    for (int32_t i = 0; i < rows->n; i++, row++, y += rows->step)
        pel_blend565_run(pel_address16(rows->surface, row->x0, y),
                         row->x1 - row->x0, &b);
}

#endif
