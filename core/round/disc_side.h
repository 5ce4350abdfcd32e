/* Columns of one side of a disc (disc.h), for disc.c and circle.c. */
#ifndef PEL_ROUND_DISC_SIDE_H
#define PEL_ROUND_DISC_SIDE_H

#include "../format/word.h"
#include "disc.h"

static PEL_ALWAYS_INLINE void pel_disc_side_add(int64_t *d, int32_t *u,
                                                int32_t *columns, int32_t limit)
{
    while (*d >= 0 && *columns < limit) {
        *d -= *u + 128;
        *u += 256;
        ++*columns;
    }
}

static PEL_ALWAYS_INLINE void pel_disc_side_remove(int64_t *d, int32_t *u,
                                                   int32_t *columns)
{
    while (*columns > 0 && *d + *u - 128 < 0) {
        *u -= 256;
        *d += *u + 128;
        --*columns;
    }
}

/* Adds or removes columns until d and u are those of the row; at most `limit`
 * columns. No column is removed when d >= 0 at the start (u >= 128 once there
 * are columns); calling both is less code. */
static PEL_ALWAYS_INLINE void pel_disc_side_adjust(int64_t *d, int32_t *u,
                                                   int32_t *columns,
                                                   int32_t limit)
{
    if (PEL_64BIT && *d < 0) {
        pel_disc_side_remove(d, u, columns);
        return;
    }
    pel_disc_side_add(d, u, columns, limit);
    if (!PEL_64BIT)
        pel_disc_side_remove(d, u, columns);
}

#endif
