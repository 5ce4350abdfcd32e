/* Columns of one side of a disc (disc.h), for disc.c and circle.c. */
#ifndef PEL_ROUND_DISC_SIDE_H
#define PEL_ROUND_DISC_SIDE_H

#include "../format/word.h"
#include "disc.h"

/* Adds or removes columns until d and u are those of the row; at most `limit`
 * columns. */
static PEL_ALWAYS_INLINE void pel_disc_side_adjust(int64_t *d, int32_t *u,
                                                   int32_t *columns,
                                                   int32_t limit)
{
    if (*d < 0) {
        for (; *columns > 0 && *d + *u - 128 < 0; --*columns) {
            *u -= 256;
            *d += *u + 128;
        }
        return;
    }
    for (; *d >= 0 && *columns < limit; ++*columns) {
        *d -= *u + 128;
        *u += 256;
    }
}

#endif
