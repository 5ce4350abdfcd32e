/* Where the cells of a linear gradient lie; of paint_linear.c alone. */
#ifndef PEL_PAINT_LINEAR_CELLS_H
#define PEL_PAINT_LINEAR_CELLS_H

#include "cells.h"
#include "paint_linear.h"

static inline bool is_padded(const struct pel_linear *p)
{
    return p->base.ramp.spread == PEL_PAD;
}

/* (P - from).d of a point. */
static PEL_HOT int64_t along(const struct pel_linear *p, int32_t x, int32_t y)
{
    return pel_product(x - p->from.x, p->d.x) +
           pel_product(y - p->from.y, p->d.y);
}

/* The product (P - from).d at pixel (x, y), or another that shows the same. Of
 * a padded gradient it is above -2^47, and |d|^2 at most. Of others lengths of
 * two ways, there and back, are taken away or added until it is above 0, and 2
 * |d|^2 at most: below 2^50. */
static PEL_NOINLINE_32 PEL_UNUSED int64_t product_at(const struct pel_linear *p,
                                                     int32_t x, int32_t y,
                                                     enum pel_spread spread)
{
    int64_t product = along(p, pel_pixel_center(x), pel_pixel_center(y));
    int64_t step = p->square;
    if (spread == PEL_PAD)
        return product < step ? product : step;
    int32_t count = 0;
    for (; (uint32_t)(step >> 32) >> 17 == 0; count++)
        step *= 2;
    for (product += step; count; count--, step >>= 1)
        if (product > step)
            product -= step;
    return product;
}

/* The error of the boundary where cell k begins is n product - k square, less 1
 * where the direction is turned: there boundaries belong to the cells before
 * them. Where it is walked in 32 bits, it is counted in units of 256 n, by
 * which n product grows from pixel to pixel, and what they leave, c->whole. */
static int32_t unit_of(const struct pel_linear *p)
{
    return p->base.cells * 256;
}

/* From the boundary of a cell to that of the one `count` >= 1 cells on. */
static PEL_STEP_OR_INLINE void next_cells(struct pel_cells *c,
                                          const struct pel_linear *p,
                                          int32_t count)
{
    do {
        c->error -= p->cell;
        c->whole -= p->cell_remainder;
        if (c->whole < 0) {
            c->whole += unit_of(p);
            c->error--;
        }
    } while (--count);
}

/* The cell k of a pixel by its product, bit by bit of n, so that the error
 * where it begins, `remainder`, is 0 or more and below square. */
static PEL_HOT_LOOP int32_t find_cell(const struct pel_linear *p,
                                      pel_cell_error *remainder)
{
    const int64_t product = *remainder;
    const int32_t mirror = p->direction >> 31; /* -1 when turned, or 0 */
    int64_t error = mirror;
    /* n in the 15 upper bits makes room for k in the lower ones. */
    uint32_t bits = (uint32_t)p->base.cells << 17;
    for (int i = 15; i; i--) {
        error = 2 * error - mirror;
        if ((int32_t)bits < 0)
            error += product;
        for (bits *= 2; error >= p->square; bits++)
            error -= p->square;
    }
    *remainder = error;
    return (int32_t)bits;
}

/* Its index. Where the direction is padded, before it is the first cell, behind
 * it the last one. */
static PEL_HOT_LOOP int32_t index_of(const struct pel_linear *p,
                                     enum pel_spread spread, int32_t k)
{
    const int32_t n = p->base.cells, period = p->base.period;
    int32_t index = p->direction < 0 ? n - 1 - k : k;
    while (index >= period)
        index -= spread == PEL_PAD ? 1 : period;
    return index < 0 ? index + period : index;
}

static PEL_ALWAYS_INLINE void set_cell_here(struct pel_cells *c,
                                            const struct pel_linear *p,
                                            int64_t product)
{
    c->error = product;
    const int32_t k = find_cell(p, &c->error);
    c->index = (pel_cell_index)index_of(p, p->base.ramp.spread, k);
    if (PEL_CELL_ROWS > 1) {
        const int64_t units = pel_divide_64(&c->error, unit_of(p));
        c->whole = (int32_t)c->error;
        c->error = units;
    }
}

static PEL_NOINLINE_32 PEL_UNUSED void set_cell(struct pel_cells *c,
                                                const struct pel_linear *p,
                                                int64_t product)
{
    c->direction = (pel_cell_direction)p->direction;
    set_cell_here(c, p, product);
}

#endif
