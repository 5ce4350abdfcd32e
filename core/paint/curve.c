#include "curve.h"

#if PEL_FAST_64BIT

/* A run's curve and row. */
struct row {
    const struct pel_curve *curve;
    int32_t dy;     /* from the centre */
    int64_t square; /* dy^2 */
};

static struct row row_of(const struct pel_curve *curve, int32_t y)
{
    const int32_t dy = pel_pixel_center(y) - curve->center.y;
    return (struct row){curve, dy, pel_square(dy)};
}

/* Is every centre from dx to `way` sub-pixels right of it at least `limit` away
 * from the paint's? */
static bool is_far(const struct row *row, int32_t dx, int32_t way,
                   int32_t limit)
{
    int32_t x = dx > 0 ? dx : pel_min(dx + way, 0);
    return pel_square(x) + row->square >= pel_square(limit);
}

static int32_t way_to(const struct row *row, int32_t x)
{
    return pel_pixel_center(x) - row->curve->center.x;
}

/* log2 of the size of the piece that holds pixel x; 0 when no piece is far
 * enough. */
static PEL_WALK int piece_of(const struct row *row, int32_t x)
{
    const int32_t *far =
        row->curve->far + (PEL_PIECE_MAX_LOG2 - PEL_PIECE_MIN_LOG2);
    int32_t size = 1 << PEL_PIECE_MAX_LOG2;
    int k = PEL_PIECE_MAX_LOG2;
    for (; k >= PEL_PIECE_MIN_LOG2; k--, size >>= 1)
        if (is_far(row, way_to(row, x & -size), 256 * size, *far--))
            return k;
    return 0;
}

/* How many of n pixels from x on, in the block of 64 that holds x, show one
 * colour because they are outside: all or none. Cubics there would show it too,
 * so it does not matter that runs of other ends may cut them otherwise. */
static PEL_WALK int32_t outside_of(const struct row *row, int32_t x, int32_t n)
{
    const int32_t size = 1 << PEL_PIECE_MAX_LOG2;
    n = pel_min(n, size - (x & (size - 1)));
    return is_far(row, way_to(row, x), 256 * n, row->curve->outside) ? n : 0;
}

/* With s from 0 to 1 the cubic is a + m s + B s^2 + C s^3, m and n the slopes
 * at a and b per piece, B = 3 (b - a) - 2 m - n, C = m + n - 2 (b - a). In
 * steps of h = 2^-k the differences are m h + B h^2 + C h^3, then 2 B h^2 +
 * 6 C h^3, then 6 C h^3. The shifts lose less than 2^18 units over the piece.
 */
static void begin_walk(struct pel_ramp_walk *w, const struct pel_knot *a,
                       const struct pel_knot *b, int k)
{
    const int64_t rise = (int64_t)(b->value - a->value);
    const int64_t size = INT64_C(1) << k;
    const int64_t m = a->slope * size, n = b->slope * size;
    const int64_t curve = 3 * rise - 2 * m - n, twist = m + n - 2 * rise;
    w->at = a->value;
    w->d3 = (uint64_t)(6 * twist >> 3 * k);
    w->d2 = (uint64_t)(2 * curve >> 2 * k) + w->d3;
    w->d1 = (uint64_t)(a->slope + (curve >> 2 * k) + (twist >> 3 * k));
}

/* A piece, or the part of it that a run shows. */
struct piece {
    struct pel_ramp_walk walk;
    struct pel_knot end; /* at pixel `next` */
    int32_t next, pixels;
};

static void knot_at(const struct row *row, int32_t x, struct pel_knot *k)
{
    k->slope = row->curve->knot(row->curve, way_to(row, x), row->dy, &k->value);
}

static int32_t skip_of(int32_t x, int log2)
{
    return x & ((1 << log2) - 1);
}

static void set_outside(struct pel_ramp_walk *w, const struct row *row)
{
    const uint8_t bits = row->curve->bits;
    *w = (struct pel_ramp_walk){UINT64_C(1) << bits, 0, 0, 0, bits, false, 0};
}

/* A walk from pixel x, in the piece between knots a and b of which a piece of
 * one pixel needs the first alone. */
static void set_walk(struct pel_ramp_walk *w, const struct row *row, int log2,
                     int32_t x, const struct pel_knot k[2])
{
    const uint64_t limit = row->curve->limit;
    *w =
        (struct pel_ramp_walk){k[0].value, 0, 0, 0, row->curve->bits, false, 0};
    w->inside = k[0].value < limit;
    if (log2 == 0)
        return;
    begin_walk(w, &k[0], &k[1], log2);
    w->inside = w->inside && k[1].value < limit;
    for (int32_t skip = skip_of(x, log2); skip > 0; skip--)
        pel_ramp_step(w);
}

/* The piece that holds pixel x, of a run of n more; it may begin at the end of
 * the piece before. */
static void prepare(const struct row *row, struct piece *p,
                    const struct piece *before, int32_t x, int32_t n)
{
    /* What is outside lies side by side, but for rows that it begins. */
    p->next = x; /* where no piece after this one begins */
    p->end.value = row->curve->limit;
    if (before->end.value >= row->curve->limit &&
        (p->pixels = outside_of(row, x, n)) > 0) {
        set_outside(&p->walk, row);
        return;
    }
    const int log2 = piece_of(row, x);
    const int32_t skip = skip_of(x, log2), size = 1 << log2;
    struct pel_knot k[2];
    k[0] = before->end;
    if (before->next != x - skip)
        knot_at(row, x - skip, &k[0]);
    p->pixels = pel_min(size - skip, n);
    p->next = x + size - skip;
    knot_at(row, p->next, &k[1]);
    p->end = k[1];
    set_walk(&p->walk, row, log2, x, k);
}

/* A piece is prepared before the one to its left is coloured, so that the CPU
 * does both at once. */
void pel_curve_colors(const struct pel_curve *curve, struct pel_point pixel,
                      int32_t n, pel_color *colors)
{
    const struct row row = row_of(curve, pixel.y);
    struct piece one, other, *p = &one, *before = &other, *t;
    before->next = pixel.x + 1; /* nowhere: a piece begins at or left of x */
    before->end.value = UINT64_MAX;
    before->pixels = 0;
    for (int32_t x = pixel.x; n > 0;) {
        prepare(&row, p, before, x, n);
        x += p->pixels;
        n -= p->pixels;
        if (before->pixels > 0)
            curve->run(curve, &before->walk, before->pixels, colors);
        colors += before->pixels;
        t = before;
        before = p;
        p = t;
    }
    curve->run(curve, &before->walk, before->pixels, colors);
}

#endif
