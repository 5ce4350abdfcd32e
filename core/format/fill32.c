#include "span32.h"

void pel_fill32(const struct pel_rows *rows, uint32_t pixel)
{
    const struct pel_row *row = rows->row;
    const pel_value32 value = pel_make_value32(pixel);
    const uintptr_t pitch = (uintptr_t)pel_rows_pitch(rows);
    uintptr_t line = pel_column_zero(rows->surface, rows->y, 4);
    for (int32_t n = rows->n; n > 0; n--, row++, line += pitch) {
        uintptr_t p = line + 4 * (uintptr_t)row->x0;
        int32_t pixels = row->x1 - row->x0;
        pel_prefetch_run(p + pitch, 4 * pixels);
        pel_span32((pel_word32 *)p, pixels, value);
    }
}
