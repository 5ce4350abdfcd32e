#include "span32.h"

void pel_fill32(const struct pel_rows *rows, uint32_t pixel)
{
    const struct pel_row *row = rows->row, *end = row + rows->n;
    const pel_value32 value = pel_make_value32(pixel);
    const ptrdiff_t pitch = pel_rows_pitch(rows);
    const int32_t left = rows->surface->bounds.x0;
    uint8_t *line = pel_surface_line(rows->surface, rows->y);
    for (; row < end; row++, line += pitch)
        pel_span32((pel_word32 *)(void *)line + (row->x0 - left),
                   row->x1 - row->x0, value);
}
