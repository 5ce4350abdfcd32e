/* Whole rows of two sides: by the closed form of smooth_edge.h, pixel by pixel.
 */
#include "smooth_walk.h"

/* HALF; with flip, which is all ones for what lies left of an edge, half is
 * less than 0, as the area is, but for the 1 that a flip of its bits leaves. */
static inline uint32_t half_of(uint32_t flip)
{
    return (PEL_SMOOTH_HALF ^ flip) - 2 * flip;
}

static inline uint8_t coverage_of(uint32_t area, uint32_t flip, uint32_t half)
{
    return (uint8_t)(((area ^ flip) + half) >> 24);
}

/* The coverage of the pixels, more than one, that a side has crossed: where the
 * bytes end. *x: the first one; before, the one at the top. */
static PEL_NOINLINE_32 uint8_t *cross_pixels(const struct pel_smooth_chain *s,
                                             uint32_t flip, int32_t *x,
                                             uint8_t *to)
{
    uint32_t lo = (uint32_t)s->at - (uint32_t)s->step, hi = (uint32_t)s->at;
    int32_t between = (int32_t)(s->at >> 32) - *x;
    if (between < 0) {
        hi = lo;
        lo = (uint32_t)s->at;
        *x += between;
        between = -between;
    }
    uint8_t *const last = to + between;
    const uint32_t half = half_of(flip), u = 65536 - (lo >> 16);
    hi = PEL_SMOOTH_FULL - pel_smooth_corner(&s->rise, hi >> 16);
    *last = coverage_of(hi, flip, half);
    *to++ = coverage_of(pel_smooth_corner(&s->rise, u), flip, half);
    if (to < last) {
        uint32_t area = pel_smooth_between(&s->rise, u);
        for (; to < last; area += s->rise.value)
            *to++ = coverage_of(area, flip, half);
    }
    return last + 1;
}

/* The coverage of the pixels that a side crosses in a row: where the bytes end.
 * *x: the first one. Moves the side on. */
static PEL_NOINLINE_32 uint8_t *cross_row(struct pel_smooth_chain *s,
                                          uint32_t flip, int32_t *x,
                                          uint8_t *to)
{
    const int32_t above = (int32_t)(s->at >> 32);
    const uint32_t low = (uint32_t)s->at >> 16;
    s->at += s->step;
    const uint32_t high = (uint32_t)s->at >> 16;
    uint32_t area;
    *x = above;
    if (above != (int32_t)(s->at >> 32))
        return cross_pixels(s, flip, x, to);
    area = PEL_SMOOTH_FULL + PEL_SMOOTH_HALF - (low + high) * 32640;
    *to = (uint8_t)(((area ^ flip) - flip) >> 24);
    return to + 1;
}

/* What a side is in the row above, right of pixel x, from which it lies a
 * batch's bytes away at most; sides of round lines may lie beyond the range of
 * coordinates. */
static PEL_NOINLINE_32 void set_piece(const struct pel_smooth_chain *s,
                                      int32_t x, struct pel_smooth_piece *p)
{
    const int64_t at = s->at - x * (INT64_C(1) << 32);
    pel_smooth_piece_set(p, (int32_t)((at - s->step) >> 16),
                         (int32_t)(at >> 16));
    p->rise = s->rise;
    p->height = 65536;
}

/* Pixels that both sides cross in the last row of a batch, the last ones of the
 * left side and the first ones of the right one, are left with the left side.
 * Where the bytes end. */
static PEL_NOINLINE_32 uint8_t *merge(const struct pel_smooth_walk *k,
                                      struct pel_span *full, uint8_t *count,
                                      uint8_t *to)
{
    const int32_t left = full->x0 - count[0];
    const int32_t skip = pel_min(full->x0 - full->x1, count[1]);
    struct pel_smooth_piece piece[2];
    set_piece(&k->side[0], left, &piece[0]);
    set_piece(&k->side[1], left, &piece[1]);
    for (int32_t x = pel_max(full->x1 - left, 0); x < count[0]; x++) {
        uint32_t area = PEL_SMOOTH_HALF;
        pel_smooth_add(&piece[0], 0, x, 1, &area);
        pel_smooth_add(&piece[1], ~UINT32_C(0), x, 1, &area);
        to[x] = (uint8_t)(area >> 24);
    }
    to += count[0];
    count[1] = (uint8_t)(count[1] - skip);
    full->x1 = full->x0;
    for (int32_t n = count[1]; n > 0; n--, to++)
        *to = to[skip];
    return to;
}

int32_t pel_smooth_room(const struct pel_smooth_walk *k)
{
    int32_t most = 0, rows = PEL_SMOOTH_BATCH_ROWS;
    for (int i = 0; i < 2; i++) {
        const int32_t step = (int32_t)(k->side[i].step >> 32);
        most += pel_min(step < 0 ? ~step : step, PEL_SMOOTH_BATCH_BYTES) + 2;
    }
    while (rows * most > PEL_SMOOTH_BATCH_BYTES)
        rows--;
    return rows;
}

void pel_smooth_cross(struct pel_smooth_walk *k, int32_t n)
{
    struct pel_smooth_batch *const b = &k->of.batch;
    struct pel_span *full = b->at.full;
    uint8_t *to = b->coverage, *count = b->count;
    b->y = k->y;
    b->n = n;
    k->y += n;
    for (; n > 0; n--, full++, count += 2) {
        uint8_t *const left = to;
        to = cross_row(&k->side[0], 0, &full->x0, to);
        count[0] = (uint8_t)(to - left);
        full->x0 += count[0];
        to = cross_row(&k->side[1], ~UINT32_C(0), &full->x1, to);
        count[1] = (uint8_t)(to - left - count[0]);
        if (full->x0 > full->x1)
            to = merge(k, full, count, left);
    }
    if (!k->inside)
        pel_smooth_clip_batch(b, &k->smooth.target->clip);
}
