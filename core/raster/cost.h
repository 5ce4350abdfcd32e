/* What a triangle takes at most, known before it is drawn, so that firmware
 * keeps a deadline.
 *
 * Rows are exact. Pixels: a row of width w has less than w + 1 of them. Let W
 * be the widest and h the height. The sum of the widths, one px apart, exceeds
 * the area by (2 - sqrt 2) W at most where h >= 1 px, and by W elsewhere: for
 * given rows it is a convex function of the middle vertex's y between two rows,
 * so that the worst one lies on a row or at the end, and there the sums are
 * arithmetic series. So
 *
 *     pixels <= area + 5/8 W + rows,
 *
 * and never more than the part of the box inside the clip has.
 *
 * Instructions are a sum of the shape's numbers times rates, which were chosen
 * so that no random triangle takes more (bench/mcu/cost.c counts them in QEMU).
 * They are instructions, not cycles, and hold for code that was built as the
 * rates say. */
#ifndef PEL_RASTER_COST_H
#define PEL_RASTER_COST_H

#include "../base/rect.h"

PEL_BEGIN_DECLS

/* The sums wrap: of rows and pixels beyond 2^32. */
struct pel_cost {
    uint32_t triangles, rows, pixels;
    uint64_t instructions;
};

/* Instructions. `turn`: of a turn of the loops an edge begins with, one for
 * each bit of its quotient (without a divide instruction) and of the number of
 * rows above the clip. `cut_row`: instead of `row` in a triangle which the clip
 * cuts at the left or right, or larger than 128 px. `run`: more for a row with
 * pixels. `thin`: more for a triangle larger than 4,096 px, or thinner than 1/8
 * px. */
struct pel_cost_rates {
    uint32_t triangle, thin, turn, row, cut_row, run;
    uint32_t pixel; /* 1/16 */
};

enum pel_cost_paint {
    PEL_COST_FLAT,
    PEL_COST_ALPHA,
    PEL_COST_GOURAUD,
    PEL_COST_NEAREST,
    PEL_COST_BILINEAR,
    PEL_COST_PAINTS
};

/* Of pel_triangle on rgb565_le, Gouraud with its init: gcc 12.2 -O2 for
 * Cortex-M0+ and M4; textures are rgb565_le and not repeated. */
extern const struct pel_cost_rates pel_cost_m0plus[PEL_COST_PAINTS];
extern const struct pel_cost_rates pel_cost_m4[PEL_COST_PAINTS];

/* Adds the bound of a legal triangle. */
void pel_triangle_cost(struct pel_cost *cost, const struct pel_point v[3],
                       const struct pel_rect *clip,
                       const struct pel_cost_rates *rates);
PEL_END_DECLS
#endif
