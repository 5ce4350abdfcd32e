#include "smooth_part.h"

void pel_smooth_flush(struct pel_smooth *smooth, struct pel_smooth_part *part,
                      int32_t x)
{
    if (part->row.left + part->row.full > 0)
        pel_smooth_paint(smooth, &part->row);
    pel_smooth_part_begin(part, x, part->row.y);
}

void pel_smooth_collect(struct pel_smooth *smooth, struct pel_smooth_part *part,
                        const struct pel_span *pixels, int32_t coverage)
{
    struct pel_smooth_row *const row = &part->row;
    int32_t x = pixels->x0;
    if (coverage == 0)
        pel_smooth_flush(smooth, part, pixels->x1);
    else if (coverage == 255)
        row->full += pixels->x1 - x;
    else
        for (; x < pixels->x1; x++) {
            if (row->left == PEL_SMOOTH_BYTES || row->full > 0)
                pel_smooth_flush(smooth, part, x);
            part->bytes[row->left++] = (uint8_t)coverage;
        }
}
