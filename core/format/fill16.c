#include "span16.h"

void pel_fill16(const struct pel_rows *rows, uint32_t pixel)
{
    const struct pel_row *row = rows->row, *end = row + rows->n;
    const pel_value16 value = pel_make_value16(pixel);
    const ptrdiff_t pitch = pel_rows_pitch(rows);
    const int32_t left = rows->surface->bounds.x0;
    uint8_t *line = pel_surface_line(rows->surface, rows->y);
    for (; row < end; row++, line += pitch)
        pel_span16((pel_word16 *)(void *)line + (row->x0 - left),
                   row->x1 - row->x0, value);
}
