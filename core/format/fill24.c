#include "word24.h"

void pel_fill24(const struct pel_rows *rows, uint32_t pixel)
{
    const struct pel_row *row = rows->row;
    int32_t y = rows->y;
    for (int i = 0; i < rows->n; i++, row++, y += rows->step) {
        uint8_t *p = pel_address24(rows->surface, row->x0, y);
        for (int32_t n = row->x1 - row->x0; n > 0; n--, p += 3)
            pel_put24(p, pixel);
    }
}
