#include "span16.h"

void pel_fill16(const struct pel_rows *rows, uint32_t pixel)
{
    const struct pel_row *row = rows->row;
    const pel_value16 value = pel_make_value16(pixel);
    const uintptr_t pitch = (uintptr_t)pel_rows_pitch(rows);
    uintptr_t line = pel_column_zero(rows->surface, rows->y, 2);
    const struct pel_row *const end = row + rows->n;
    do {
        pel_span16((pel_word16 *)(line + 2 * (uintptr_t)row->x0),
                   row->x1 - row->x0, value);
        row++;
        line += pitch;
    } while (row < end);
}
