/* The walk of one side of a disc over columns (disc.h), for the two files that
 * make rows of it: disc.c, and circle.c. */
#ifndef PEL_ROUND_DISC_SIDE_H
#define PEL_ROUND_DISC_SIDE_H

#include "../format/word.h"
#include "disc.h"

/* At a row with this reach, the next column at u; the limit is set apart. */
static inline void pel_disc_side_start(struct pel_disc_side *s, int64_t reach,
                                       int32_t u)
{
    s->d = (reach - pel_square(u)) >> 9;
    s->u = u;
    s->columns = 0;
}

/* Adds or takes columns until the side is that of the present row. */
static PEL_ALWAYS_INLINE int32_t pel_disc_side_columns(struct pel_disc_side *s)
{
    while (s->d >= 0 && s->columns < s->limit) {
        s->d -= s->u + 128;
        s->u += 256;
        s->columns++;
    }
    while (s->columns > 0 && s->d + s->u - 128 < 0) {
        s->u -= 256;
        s->d += s->u + 128;
        s->columns--;
    }
    return s->columns;
}

#endif
