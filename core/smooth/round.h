/* Discs and what is made of two. */
#ifndef PEL_SMOOTH_ROUND_H
#define PEL_SMOOTH_ROUND_H

#include "outline.h"

/* A disc without a smaller one, whose four quarters lie so far apart. */
struct pel_smooth_round {
    struct pel_point center, spread; /* of the upper left quarter; 1/256 px */
    int32_t inner, outer;
    const struct pel_smooth_oval *oval; /* of the outer one, or NULL */
    /* Finds the two sides between quarters (outline.h), or NULL. */
    bool (*other)(struct pel_smooth_outline *outline, int32_t y, int32_t i,
                  struct pel_smooth_crossing *crossing);
};

/* Of legal coordinates; inner < outer, or outer is 0. */
void pel_smooth_round(const struct pel_surface *surface,
                      const struct pel_smooth_round *round,
                      const struct pel_paint *paint);

#endif
