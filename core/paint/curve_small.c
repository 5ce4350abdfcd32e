/* Curves on small CPUs: the pieces and cubics of curve_colors.h in little
 * stack. What is recomputed here need not be kept while a paint computes its
 * knots. */
#include "curve.h"

#if !PEL_FAST_64BIT

static int32_t way_to(int32_t pixel, int32_t center)
{
    return pel_pixel_center(pixel) - center;
}

/* Is every centre from (x, y) to `n` pixels right of it at least `limit` away
 * from the paint's? */
static PEL_NOINLINE bool is_far(const struct pel_curve *curve, int32_t x,
                                int32_t y, int32_t n, int32_t limit)
{
    const int32_t dx = way_to(x, curve->center.x);
    const int32_t nearest = dx > 0 ? dx : pel_min(dx + 256 * n, 0);
    return pel_square(nearest) + pel_square(way_to(y, curve->center.y)) >=
           pel_square(limit);
}

/* log2 of the size of the piece that the run begins in, 0 for one pixel; -1
 * when its pixels are outside, up to the end of a block of the largest size:
 * all or none. Cubics there would show the same colour, so it does not matter
 * that runs of other ends may cut them otherwise. */
static PEL_NOINLINE int find_piece(const struct pel_curve *curve,
                                   const struct pel_strip *s)
{
    int32_t size = 1 << PEL_PIECE_MAX_LOG2;
    const int32_t n = pel_min(s->walk.n, size - (s->x & (size - 1)));
    if (is_far(curve, s->x, s->y, n, curve->outside))
        return -1;
    for (int k = PEL_PIECE_MAX_LOG2; k >= PEL_PIECE_MIN_LOG2; k--, size >>= 1)
        if (is_far(curve, s->x & -size, s->y, size,
                   curve->least[k - PEL_PIECE_MIN_LOG2]))
            return k;
    return 0;
}

/* How many pixels of its piece a strip's first one is on. */
static PEL_NOINLINE int32_t skip_of(const struct pel_strip *s, int log2)
{
    return s->x & ((1 << log2) - 1);
}

/* From the centre to the piece's first pixel. */
static PEL_NOINLINE int32_t x_of(const struct pel_curve *curve,
                                 const struct pel_strip *s, int log2)
{
    return way_to(s->x - skip_of(s, log2), curve->center.x);
}

/* From the knots to the differences, with the same bits as pel_curve_walk. */
static PEL_NOINLINE void set_differences(struct pel_ramp_walk *w, int log2)
{
    const uint64_t rise = w->d2 - w->at;
    const uint64_t m = w->d1 << log2, n = w->d3 << log2;
    const int64_t twist = (int64_t)(m + n - 2 * rise);
    const int64_t curve = (int64_t)(rise - m) - twist;
    w->d3 = (uint64_t)((int64_t)pel_times((uint64_t)twist, 6) >> 3 * log2);
    w->d2 = (uint64_t)(2 * curve >> 2 * log2) + w->d3;
    w->d1 += (uint64_t)((curve >> 2 * log2) + (twist >> 3 * log2));
}

static void stay_at(struct pel_ramp_walk *w, uint64_t at)
{
    w->at = at;
    w->d1 = 0;
    w->d2 = 0;
    w->d3 = 0;
}

/* Value and slope of a piece's first knot into at and d1, of its second into d2
 * and d3, and the walk of them. */
static void set_piece(const struct pel_curve *curve, struct pel_strip *s,
                      int log2)
{
    struct pel_ramp_walk *w = &s->walk;
    w->d1 = (uint64_t)curve->knot(curve, x_of(curve, s, log2),
                                  way_to(s->y, curve->center.y), &w->at);
    w->d3 = (uint64_t)curve->knot(curve, x_of(curve, s, log2) + (256 << log2),
                                  way_to(s->y, curve->center.y), &w->d2);
    w->inside = w->at < curve->limit && (log2 == 0 || w->d2 < curve->limit);
    if (log2 == 0)
        stay_at(w, w->at);
    else
        set_differences(w, log2);
    for (int32_t skip = skip_of(s, log2); skip > 0; skip--)
        pel_ramp_step(w);
}

void pel_curve_begin(const void *part, struct pel_strip *s)
{
    const struct pel_curve *curve = part;
    int log2 = find_piece(curve, s);
    s->walk.bits = curve->bits;
    s->walk.inside = false;
    if (log2 >= 0) {
        set_piece(curve, s, log2);
    } else {
        stay_at(&s->walk, UINT64_C(1) << curve->bits);
        log2 = PEL_PIECE_MAX_LOG2;
    }
    s->walk.n = pel_min((1 << log2) - skip_of(s, log2), s->walk.n);
}

void pel_curve_follow(const void *part, struct pel_ramp_walk *walk, int32_t n,
                      pel_color *colors)
{
    const struct pel_curve *curve = part;
    curve->run(curve, walk, n, colors);
}

#endif
