#include "patch.h"
#include "ramp_lanes.h"

#if PEL_PATCHES

const int64_t pel_patch_far[PEL_PATCH_SIZES] = {
    INT64_C(65536) * 320 * 100,
    INT64_C(65536) * 80 * 64,
    INT64_C(65536) * 20 * 36,
};

/* From around a pixel to around the one u to the right of it and v below. */
static void move(struct pel_taylor *t, uint64_t u, uint64_t v)
{
    t->at += u * (t->x + u * (t->xx + u * t->xxx) + v * (t->xy + u * t->xxy)) +
             v * (t->y + v * (t->yy + v * t->yyy + u * t->xyy));
    t->x += u * (2 * t->xx + 3 * u * t->xxx + 2 * v * t->xxy) +
            v * (t->xy + v * t->xyy);
    t->y += v * (2 * t->yy + 3 * v * t->yyy + 2 * u * t->xyy) +
            u * (t->xy + u * t->xxy);
    t->xx += 3 * u * t->xxx + v * t->xxy;
    t->xy += 2 * (u * t->xxy + v * t->xyy);
    t->yy += 3 * v * t->yyy + u * t->xyy;
}

static PEL_ALWAYS_INLINE struct pel_lanes lanes_of(uint64_t at, uint64_t d1,
                                                   uint64_t d2, uint64_t d3,
                                                   int shift)
{
    const struct pel_ramp_walk w = {at, d1, d2, d3, 0, true, 0};
    return pel_lanes_of(&w, shift);
}

/* The differences of a polynomial around its first pixel. */
static void set_lanes(struct pel_grid *g, const struct pel_taylor *t, int shift)
{
    const uint64_t xxx = 6 * t->xxx, yyy = 6 * t->yyy;
    g->row[0] =
        lanes_of(t->at, t->x + t->xx + t->xxx, 2 * t->xx + xxx, xxx, shift);
    g->row[1] = lanes_of(t->y + t->yy + t->yyy, t->xy + t->xxy + t->xyy,
                         2 * t->xxy, 0, shift);
    g->row[2] = lanes_of(2 * t->yy + yyy, 2 * t->xyy, 0, 0, shift);
    g->row[3] = lanes_of(yyy, 0, 0, 0, shift);
}

/* A patch that is not outside ends at most 1 + 36, 19 or 10 pixels beyond the
 * padded ramp, which is then, by pel_patch_far, at least 159, 61 or 21 pixels
 * long: no position reaches 2. */
bool pel_patch_grid(const struct pel_patchwork *work, struct pel_point way,
                    int size, struct pel_grid *grid)
{
    const struct pel_ramp *ramp = work->ramp;
    const int bits = work->curve->bits;
    const uint64_t n = ramp->n == 2 ? 256 : (uint64_t)ramp->n;
    struct pel_taylor t;
    work->taylor(work->curve, way.x, way.y, size, &t);
    const bool padded =
        ramp->spread == PEL_PAD && t.at + t.reach >= UINT64_C(1) << (bits & 63);
    const int shift = (padded ? 62 : 64) - bits;
    const uint64_t error = (t.error << shift >> 31) + PEL_GRID_ERROR + 2;
    if (error * n >> (25 + size) != 0)
        return false;
    grid->padded = padded;
    grid->width = PEL_GRID_WIDTH >> size;
    grid->error = (uint32_t)error;
    t.at -= t.error;
    move(&t, 0 - (uint64_t)(PEL_GRID_WIDTH / 2 >> size),
         0 - (uint64_t)(PEL_GRID_ROWS / 2 >> size));
    set_lanes(grid, &t, shift);
    return true;
}

#endif
