/* Collects a row of pixels of any coverage in parts as pel_smooth_paint takes
 * them. */
#ifndef PEL_SMOOTH_SMOOTH_PART_H
#define PEL_SMOOTH_SMOOTH_PART_H

#include "smooth.h"

enum { PEL_SMOOTH_BYTES = PEL_64BIT ? 64 : PEL_SMALL_CODE ? 8 : 16 };

struct pel_smooth_part {
    struct pel_smooth_row row;
    uint8_t bytes[PEL_SMOOTH_BYTES];
};

static inline void pel_smooth_part_begin(struct pel_smooth_part *part,
                                         int32_t x, int32_t y)
{
    part->row = (struct pel_smooth_row){y, x, 0, 0, 0, part->bytes};
}

/* Pixels x to end, of one coverage, behind those before. */
void pel_smooth_collect(struct pel_smooth *smooth, struct pel_smooth_part *part,
                        const struct pel_span *pixels, int32_t coverage);

/* Paints what is there; the next pixel is x. */
void pel_smooth_flush(struct pel_smooth *smooth, struct pel_smooth_part *part,
                      int32_t x);

#endif
