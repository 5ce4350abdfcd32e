#include <string.h>

#include "word8.h"

void pel_fill8(const struct pel_rows *rows, uint32_t pixel)
{
    const struct pel_row *row = rows->row;
    int32_t y = rows->y;
    for (int i = 0; i < rows->n; i++, row++, y += rows->step)
        if (row->x0 < row->x1)
            memset(pel_address8(rows->surface, row->x0, y), (int)pixel,
                   (size_t)(row->x1 - row->x0));
}
