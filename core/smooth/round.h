/* Discs and what is made of two. */
#ifndef PEL_SMOOTH_ROUND_H
#define PEL_SMOOTH_ROUND_H

#include "outline.h"
#include "short_outline.h"

#if PEL_SMOOTH_TINY
/* A disc. */
struct pel_smooth_round {
    struct pel_smooth_short_outline outline; /* first */
    struct pel_point center;                 /* of its first quarter, .. */
    struct pel_point spread; /* .. and from there to the third one's */
    int32_t radius;
    uint32_t inverse;
};

/* Sets its curve (struct pel_smooth_kind). */
bool pel_smooth_round_curve(const struct pel_smooth_short_outline *round,
                            int32_t i, struct pel_smooth_curve *curve);

/* Begins to paint a whole curve, which reaches so far from its centre. */
bool pel_smooth_curve_begin(struct pel_smooth_short_outline *outline,
                            const struct pel_smooth_curve *curve,
                            int32_t reach);
#else
struct pel_smooth_round {
    struct pel_smooth_outline outline; /* first */
    struct pel_point center, spread;
    int32_t radius;
    struct pel_smooth_curve curve[2];
};

/* Takes a smaller disc out of one that has begun, if its radius is not 0. */
void pel_smooth_round_cut(struct pel_smooth_round *round, int32_t radius);

bool pel_smooth_curve_begin(struct pel_smooth_outline *outline,
                            struct pel_smooth_curve *curve, int32_t reach);
#endif

/* Begins to paint it, of legal coordinates: center, spread, radius and `smooth`
 * are set. False: nothing is to be seen. */
bool pel_smooth_round_begin(struct pel_smooth_round *round);

#endif
