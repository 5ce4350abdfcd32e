/* A row of a shape, bit by bit: runs of columns that its sides cross, and
 * others of one coverage between them. */
#ifndef PEL_SMOOTH_SMOOTH_ROW_H
#define PEL_SMOOTH_SMOOTH_ROW_H

#include "smooth.h"

/* Pixels whose coverage is asked for at a time. */
enum { PEL_SMOOTH_PIXELS = PEL_64BIT ? 32 : 8 };

struct pel_smooth_columns {
    struct pel_span left; /* to do: cut off what is done */
    const struct pel_span *crossed;
    int n;
    /* Writes the coverage of n pixels from x on. */
    void (*cover)(const void *shape, int32_t x, int32_t n, uint8_t *to);
    const void *shape;
    int32_t even; /* the coverage of columns that no side crosses; or -1: it
                     differs */
};

/* Makes a batch of one row of the first columns that are left. */
void pel_smooth_cover(struct pel_smooth_columns *columns,
                      struct pel_smooth_batch *batch);

#endif
