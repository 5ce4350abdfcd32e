/* Discs and what is made of two. */
#ifndef PEL_SMOOTH_ROUND_H
#define PEL_SMOOTH_ROUND_H

#include "outline.h"
#include "short_outline.h"

#if PEL_SMOOTH_TINY
/* A disc; or without a smaller one, if radius[1] > 0. */
struct pel_smooth_round {
    struct pel_smooth_short_outline outline; /* first */
    struct pel_point center;                 /* of its first quarter, .. */
    struct pel_point spread; /* .. and from there to the third one's */
    int32_t radius[2];
    uint32_t inverse[2];
};

/* Sets a curve of it (struct pel_smooth_kind). */
bool pel_smooth_round_curve(const struct pel_smooth_short_outline *round,
                            int32_t i, struct pel_smooth_curve *curve);

extern const struct pel_smooth_kind pel_smooth_discs, pel_smooth_rings;

/* Begins to paint a whole curve, which reaches so far from its centre. */
bool pel_smooth_curve_begin(struct pel_smooth_short_outline *outline,
                            const struct pel_smooth_curve *curve,
                            int32_t reach);

/* Paints what is to be seen of circles. */
static PEL_ALWAYS_INLINE void pel_smooth_round_paint(
    struct pel_smooth_round *round, bool is_ring)
{
    pel_smooth_short_outline_paint(
        &round->outline, is_ring ? &pel_smooth_rings : &pel_smooth_discs);
}
#else
struct pel_smooth_round {
    struct pel_smooth_outline outline; /* first */
    struct pel_point center, spread;
    int32_t radius[2];
    struct pel_smooth_curve curve[2];
};

bool pel_smooth_curve_begin(struct pel_smooth_outline *outline,
                            struct pel_smooth_curve *curve, int32_t reach);

static inline void pel_smooth_round_paint(struct pel_smooth_round *round,
                                          bool is_ring)
{
    PEL_CAST(void, is_ring);
    pel_smooth_outline_paint(&round->outline);
}
#endif

/* Begins to paint it, of legal coordinates: center, spread, radius and `smooth`
 * are set. False: nothing is to be seen. */
bool pel_smooth_round_begin(struct pel_smooth_round *round);

#endif
