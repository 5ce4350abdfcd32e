#include "blend32.h"

#if PEL_VECTORS

enum { ROWS_AHEAD = 4 };

void pel_blend32_rows(const struct pel_rows *rows, pel_color color)
{
    if (pel_alpha(color) == 0)
        return; /* the X byte stays as it is, too */
    const struct pel_blend32 b = pel_blend32_make(rows->surface->format, color);
    const struct pel_row *row = rows->row;
    const uintptr_t ahead = ROWS_AHEAD * (uintptr_t)pel_rows_pitch(rows);
    int32_t y = rows->y;
    for (int32_t i = 0; i < rows->n; i++, row++, y += rows->step)
        pel_blend32_run(pel_address32(rows->surface, row->x0, y),
                        row->x1 - row->x0, &b, ahead);
}

#endif
