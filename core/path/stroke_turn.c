/* Joins, caps and dots of a stroke. The border goes around a point clockwise on
 * screen: from n, half of the width to the left of a line that arrives, to what
 * is left of the one that leaves, and on the other side back. */
#include "../base/divide.h"
#include "stroker.h"

/* 32,768 sin of 64ths of a turn, up to a quarter. */
static const uint16_t sines[17] = {0,     3212,  6393,  9512,  12540, 15447,
                                   18205, 20788, 23170, 25330, 27246, 28899,
                                   30274, 31357, 32138, 32610, 32768};

/* p turned clockwise by i 2^-k of a turn, less than a 64th: t in 2^-16, sin t
 * = t - t^3 / 6, 1 - cos t = t^2 / 2. */
static struct pel_point turned(struct pel_point p, uint32_t i, int k)
{
    const int32_t t = (int32_t)(i * 411775) >> k;
    const int32_t square = t * t >> 16,
                  sin = t - ((square * t >> 16) * 10923 >> 16);
    return (struct pel_point){p.x - ((p.y * sin + p.x * (square / 2)) >> 16),
                              p.y + ((p.x * sin - p.y * (square / 2)) >> 16)};
}

/* Corner i of a circle of 2^k, 32,768 away: of 64 by the table. */
static struct pel_point corner_of(uint32_t i, int k)
{
    const int more = pel_max(k - 6, 0);
    const uint32_t at = k < 6 ? i << (6 - k) : i >> more;
    struct pel_point d = {sines[16 - (at & 15)], sines[at & 15]};
    for (uint32_t quarter = at >> 4 & 3; quarter > 0; quarter--)
        d = (struct pel_point){-d.y, d.x};
    return more ? turned(d, i & ((UINT32_C(1) << more) - 1), k) : d;
}

/* The last one before a direction, which is 32,768 long, or in it. */
uint32_t pel_stroke_corner(struct pel_point p, int k)
{
    uint32_t quarter = 0, i = 0;
    for (; p.x <= 0 || p.y < 0; quarter++)
        p = (struct pel_point){p.y, -p.x};
    for (uint32_t bit = UINT32_C(1) << (k - 3); bit > 0; bit /= 2) {
        const struct pel_point d = corner_of(i + bit, k);
        if (p.y * d.x >= p.x * d.y)
            i += bit;
    }
    return (quarter << (k - 2)) + i;
}

/* round(v of corner_of radius / 32,768); of small circles below 2^31. */
static int32_t scaled(const struct pel_stroker *s, int32_t v)
{
    if (s->circle > 6)
        return (int32_t)((pel_product(v, s->round) + 16384) >> 15);
    return (v * s->round + 16384) >> 15;
}

/* That corner, or the one on the other side. */
static uint32_t opposite(const struct pel_stroker *s, uint32_t corner,
                         bool other)
{
    return corner + ((uint32_t)other << (s->circle - 1));
}

/* The corners of the circle behind number i, up to number `to`. Rounding may
 * make the first one the later one of two directions that are nearly the same:
 * then they are all of the circle, which the stroke covers anyway. */
static void arc(struct pel_stroker *s, uint32_t i, uint32_t to)
{
    for (uint32_t n = (to - i) & ((UINT32_C(1) << s->circle) - 1); n > 0; n--) {
        const struct pel_point d = corner_of(++i, s->circle);
        pel_border_to(s, scaled(s, d.x), scaled(s, d.y));
    }
}

int32_t pel_stroke_part(int32_t v, int32_t a, int32_t b)
{
    const uint64_t n = (uint64_t)pel_product(pel_magnitude(v), a);
    const int32_t part = (int32_t)pel_divide(n + (uint32_t)b / 2, (uint32_t)b);
    return v < 0 ? -part : part;
}

/* To where the sides meet, if that is within the limit l: 1 / cos(turn / 2)
 * <= l, and 2 cos(turn / 2)^2 = 1 + cos(turn). Half of the sum of two
 * directions is 2^29 at most, k 2^21 at least. */
static PEL_NOINLINE_32 void miter(struct pel_stroker *s)
{
    const struct pel_stroke_line *const m = s->from, *const n = s->to;
    const int64_t cos =
        (pel_product(m->u.x, n->u.x) + pel_product(m->u.y, n->u.y)) >> 30;
    const int32_t k = (1 << 28) + (int32_t)cos;
    if (pel_product(s->limit * s->limit, k) < INT64_C(1) << 45)
        return;
    pel_border_to(
        s, s->side * pel_stroke_part((m->u.y + n->u.y) / 2, s->half, k),
        -s->side * pel_stroke_part((m->u.x + n->u.x) / 2, s->half, k));
}

void pel_border_beside(struct pel_stroker *s,
                       const struct pel_stroke_line *line, int32_t side)
{
    pel_border_to(s, side * line->n.x, side * line->n.y);
}

void pel_border_move(struct pel_stroker *s, const struct pel_stroke_line *line,
                     int32_t side)
{
    struct pel_sides *const sides = s->pen.sides;
    if (!sides->in_piece)
        sides->at = sides->start = (struct pel_point){
            s->p.x + side * line->n.x, s->p.y + side * line->n.y};
    else
        pel_border_beside(s, line, side);
    sides->in_piece = sides->kind->end;
}

/* Back from where a turn ended to where it began: through the point, or on the
 * inner side, straight where both lines are so long that they cover what lies
 * between that and the point. */
static PEL_NOINLINE_32 void turn_back(struct pel_stroker *s)
{
    const bool pieces = s->pen.sides->kind->end;
    if (!pieces)
        pel_border_move(s, s->to, -s->side);
    if (pieces || !s->from->is_long || !s->to->is_long)
        pel_border_to(s, 0, 0);
    if (!pieces)
        pel_border_beside(s, s->from, -s->side);
    pel_border_end(s);
}

/* False: it is not near the rows. */
static PEL_NOINLINE_32 bool begin_turn(struct pel_stroker *s,
                                       const struct pel_stroke_line *n)
{
    const struct pel_stroke_line *const m = &s->last;
    const bool right =
        pel_product(m->u.x, n->u.y) >= pel_product(m->u.y, n->u.x);
    s->p = s->at;
    s->from = right ? m : n;
    s->to = right ? n : m;
    s->side = right ? 1 : -1;
    return s->p.y >= s->pen.top && s->p.y <= s->pen.bottom;
}

/* The outer side, and back. */
void pel_stroke_join(struct pel_stroker *s, const struct pel_stroke_line *next)
{
    if (!begin_turn(s, next))
        return;
    pel_border_move(s, s->from, s->side);
    if (s->stroke->join == PEL_JOIN_ROUND)
        arc(s, opposite(s, s->from->corner, s->side < 0),
            opposite(s, s->to->corner, s->side < 0));
    else if (s->stroke->join == PEL_JOIN_MITER)
        miter(s);
    pel_border_beside(s, s->to, s->side);
    turn_back(s);
}

/* From one side of s->p around it to the other. */
static void cap(struct pel_stroker *s, const struct pel_stroke_line *line,
                int32_t side)
{
    const struct pel_point n = {side * line->n.x, side * line->n.y};
    const uint32_t corner = opposite(s, line->corner, side < 0);
    pel_border_move(s, line, side);
    if (s->stroke->cap == PEL_CAP_ROUND) {
        arc(s, corner, opposite(s, corner, true));
    } else if (s->stroke->cap == PEL_CAP_SQUARE) {
        pel_border_to(s, n.x - n.y, n.y + n.x);
        pel_border_to(s, -n.x - n.y, n.x - n.y);
    }
    pel_border_beside(s, line, -side);
    pel_border_end(s);
}

void pel_stroke_begin(struct pel_stroker *s)
{
    s->p = s->start;
    cap(s, &s->first, -1);
}

void pel_stroke_end(struct pel_stroker *s)
{
    s->p = s->at;
    cap(s, &s->last, 1);
}

void pel_stroke_dot(struct pel_stroker *s)
{
    s->p = s->start;
    if (s->stroke->cap == PEL_CAP_BUTT)
        return;
    cap(s, &s->first, 1);
    cap(s, &s->first, -1);
}
