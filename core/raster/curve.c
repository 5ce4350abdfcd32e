#include "curve.h"

/* Is every centre from (dx, dy) to `way` sub-pixels right of it at least
 * `limit` away from (0, 0)? */
static bool is_far(int32_t dx, int32_t dy, int32_t way, int32_t limit)
{
    int32_t x = dx > 0 ? dx : pel_min(dx + way, 0);
    return (int64_t)x * x + (int64_t)dy * dy >= (int64_t)limit * limit;
}

/* log2 of the size of the piece that holds pixel x; 0 when no piece is far
 * enough. */
static int piece_of(const struct pel_curve *c, int32_t x)
{
    const struct pel_point way = {c->way.x + (x - c->x) * 256, c->way.y};
    for (int k = PEL_PIECE_MAX_LOG2; k >= PEL_PIECE_MIN_LOG2; k--) {
        int32_t skip = x & ((1 << k) - 1);
        if (is_far(way.x - skip * 256, way.y, 256 << k,
                   c->far[k - PEL_PIECE_MIN_LOG2]))
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

static void knot_at(const struct pel_curve *c, int32_t x, struct pel_knot *k)
{
    const struct pel_point way = {c->way.x + (x - c->x) * 256, c->way.y};
    c->knot(c->paint, way, k);
}

/* A piece, or the part of it that a run shows. */
struct piece {
    struct pel_ramp_walk walk;
    struct pel_knot end; /* at pixel `next` */
    int32_t next, pixels;
};

/* The piece that holds pixel x, of a run of n more; it may begin at the end of
 * the piece before. */
static void prepare(const struct pel_curve *c, struct piece *p,
                    const struct piece *before, int32_t x, int32_t n)
{
    const int log2 = piece_of(c, x);
    const int32_t size = 1 << log2;
    int32_t skip = x & (size - 1);
    struct pel_knot own;
    const struct pel_knot *begin = &before->end;
    if (before->next != x - skip) {
        knot_at(c, x - skip, &own);
        begin = &own;
    }
    p->pixels = pel_min(size - skip, n);
    p->walk = (struct pel_ramp_walk){begin->value, 0, 0, 0, c->bits, false};
    p->walk.inside = begin->value < c->limit;
    p->next = x + size - skip;
    knot_at(c, p->next, &p->end);
    if (log2 == 0)
        return;
    begin_walk(&p->walk, begin, &p->end, log2);
    p->walk.inside = p->walk.inside && p->end.value < c->limit;
    for (; skip > 0; skip--)
        pel_ramp_step(&p->walk);
}

/* A piece is prepared before the one to its left is coloured, so that a CPU
 * may do both at once. */
void pel_curve_colors(const struct pel_curve *c, int32_t n, pel_color *colors)
{
    struct piece one, other, *p = &one, *next = &other, *t;
    int32_t x = c->x;
    other.next = x + 1; /* nowhere: x - skip is never that */
    prepare(c, p, next, x, n);
    while (n > p->pixels) {
        n -= p->pixels;
        x += p->pixels;
        prepare(c, next, p, x, n);
        c->run(c->paint, &p->walk, p->pixels, colors);
        colors += p->pixels;
        t = p;
        p = next;
        next = t;
    }
    c->run(c->paint, &p->walk, p->pixels, colors);
}
