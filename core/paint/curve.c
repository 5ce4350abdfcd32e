#include "curve.h"

#include "../pel_config.h"

/* Is every centre from (dx, dy) to `way` sub-pixels right of it at least
 * `limit` away from (0, 0)? */
static bool is_far(int32_t dx, int32_t dy, int32_t way, int32_t limit)
{
    int32_t x = dx > 0 ? dx : pel_min(dx + way, 0);
    return (int64_t)x * x + (int64_t)dy * dy >= (int64_t)limit * limit;
}

/* A run's curve, paint and row. */
struct row {
    const struct pel_curve *curve;
    const void *paint;
    int32_t dy; /* from the centre */
};

static int32_t way_to(const struct row *row, int32_t x)
{
    return pel_pixel_center(x) - row->curve->center.x;
}

/* log2 of the size of the piece that holds pixel x; 0 when no piece is far
 * enough. */
static int piece_of(const struct row *row, int32_t x)
{
    const int32_t *far = row->curve->far;
    for (int k = PEL_PIECE_MAX_LOG2; k >= PEL_PIECE_MIN_LOG2; k--) {
        int32_t skip = x & ((1 << k) - 1);
        if (is_far(way_to(row, x - skip), row->dy, 256 << k,
                   far[k - PEL_PIECE_MIN_LOG2]))
            return k;
    }
    return 0;
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
    const int64_t m = a->slope * (1 << k), n = b->slope * (1 << k);
    const int64_t curve = 3 * rise - 2 * m - n, twist = m + n - 2 * rise;
    w->at = a->value;
    w->d3 = (uint64_t)(6 * twist >> 3 * k);
    w->d2 = (uint64_t)(2 * curve >> 2 * k) + w->d3;
    w->d1 = (uint64_t)(a->slope + (curve >> 2 * k) + (twist >> 3 * k));
}

static void knot_at(const struct row *row, int32_t x, struct pel_knot *k)
{
    const struct pel_point way = {way_to(row, x), row->dy};
    row->curve->knot(row->paint, way, k);
}

static int32_t skip_of(int32_t x, int log2)
{
    return x & ((1 << log2) - 1);
}

/* A walk from pixel x, in the piece between knots a and b of which a piece of
 * one pixel needs the first alone. */
static void set_walk(struct pel_ramp_walk *w, const struct row *row, int log2,
                     int32_t x, const struct pel_knot k[2])
{
    const uint64_t limit = row->curve->limit;
    *w = (struct pel_ramp_walk){k[0].value, 0, 0, 0, row->curve->bits, false};
    w->inside = k[0].value < limit;
    if (log2 == 0)
        return;
    begin_walk(w, &k[0], &k[1], log2);
    w->inside = w->inside && k[1].value < limit;
    for (int32_t skip = skip_of(x, log2); skip > 0; skip--)
        pel_ramp_step(w);
}

#if PEL_FAST_64BIT

/* A piece, or the part of it that a run shows. */
struct piece {
    struct pel_ramp_walk walk;
    struct pel_knot end; /* at pixel `next` */
    int32_t next, pixels;
};

/* The piece that holds pixel x, of a run of n more; it may begin at the end of
 * the piece before. */
static void prepare(const struct row *row, struct piece *p,
                    const struct piece *before, int32_t x, int32_t n)
{
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
void pel_curve_colors(const struct pel_curve *curve, const void *paint,
                      struct pel_point pixel, int32_t n, pel_color *colors)
{
    const struct row row = {curve, paint,
                            pel_pixel_center(pixel.y) - curve->center.y};
    struct piece one, other, *p = &one, *next = &other, *t;
    int32_t x = pixel.x;
    other.next = x + 1; /* nowhere: x - skip is never that */
    prepare(&row, p, next, x, n);
    while (n > p->pixels) {
        n -= p->pixels;
        x += p->pixels;
        prepare(&row, next, p, x, n);
        curve->run(paint, &p->walk, p->pixels, colors);
        colors += p->pixels;
        t = p;
        p = next;
        next = t;
    }
    curve->run(paint, &p->walk, p->pixels, colors);
}

#else

/* Runs are short here, and stack is dear. */
static PEL_NOINLINE void prepare(struct pel_ramp_walk *w, const struct row *row,
                                 int log2, int32_t x)
{
    const int32_t first = x - skip_of(x, log2);
    struct pel_knot k[2];
    knot_at(row, first, &k[0]);
    if (log2 > 0)
        knot_at(row, first + (1 << log2), &k[1]);
    set_walk(w, row, log2, x, k);
}

void pel_curve_colors(const struct pel_curve *curve, const void *paint,
                      struct pel_point pixel, int32_t n, pel_color *colors)
{
    const struct row row = {curve, paint,
                            pel_pixel_center(pixel.y) - curve->center.y};
    struct pel_ramp_walk w;
    for (int32_t part; n > 0; n -= part, colors += part, pixel.x += part) {
        const int log2 = piece_of(&row, pixel.x);
        part = pel_min((1 << log2) - skip_of(pixel.x, log2), n);
        prepare(&w, &row, log2, pixel.x);
        curve->run(paint, &w, part, colors);
    }
}

#endif
