/* Joins, caps and dots of a stroke. The border goes around a point clockwise on
 * screen: from n, half of the width to the left of a line that arrives, to what
 * is left of the one that leaves, and on the other side back. */
#include "../base/divide.h"
#include "../base/trig.h"
#include "stroker.h"

static void border_to(struct pel_stroker *s, int32_t x, int32_t y)
{
    const struct pel_point from = s->border;
    s->border = (struct pel_point){x, y};
    pel_stroke_side(s, from, s->border);
}

static struct pel_point negative(struct pel_point p)
{
    return (struct pel_point){-p.x, -p.y};
}

/* 32,768 sin of 64ths of a turn, up to a quarter. */
static const uint16_t sines[17] = {0,     3212,  6393,  9512,  12540, 15447,
                                   18205, 20788, 23170, 25330, 27246, 28899,
                                   30274, 31357, 32138, 32610, 32768};

/* The corner of the circle, 32,768 px away; of small ones by the table. */
static struct pel_point corner_of(const struct pel_stroker *s, uint32_t i)
{
    if (s->circle > 6)
        return pel_direction((uint16_t)(i << (16 - s->circle)));
    i <<= 6 - s->circle;
    const struct pel_point d = {sines[16 - (i & 15)], sines[i & 15]};
    switch (i >> 4 & 3) {
    case 0:
        return d;
    case 1:
        return (struct pel_point){-d.y, d.x};
    case 2:
        return (struct pel_point){-d.x, -d.y};
    default:
        return (struct pel_point){d.y, -d.x};
    }
}

/* The last corner before a direction, or in it: of small circles, whose radius
 * is below 2^12, by the table, in the quarter that has it. */
static uint32_t corner_before(const struct pel_stroker *s, struct pel_point p)
{
    uint32_t quarter = 0, i = 0;
    if (s->circle > 6)
        return pel_turn_of(p.x, p.y) >> (32 - s->circle);
    for (; p.x <= 0 || p.y < 0; quarter++)
        p = (struct pel_point){p.y, -p.x};
    for (uint32_t bit = 8; bit > 0; bit /= 2)
        if (p.y * sines[16 - (i + bit)] >= p.x * sines[i + bit])
            i += bit;
    return (quarter * 16 + i) >> (6 - s->circle);
}

/* round(v of corner_of radius / 32,768). */
static int32_t scaled(const struct pel_stroker *s, int32_t v)
{
    if (s->circle > 6)
        return (int32_t)((pel_product(v, s->round) + 16384) >> 15);
    return (v * s->round + 16384) >> 15;
}

/* The corners of the circle that lie between two directions. Rounding may make
 * the first one the later one of two that are nearly the same: then they are
 * all of the circle, which the stroke covers anyway. */
static void arc(struct pel_stroker *s, struct pel_point p,
                struct pel_point from, struct pel_point to)
{
    uint32_t i = corner_before(s, from);
    uint32_t n = (corner_before(s, to) - i) & ((UINT32_C(1) << s->circle) - 1);
    for (; n > 0; n--) {
        const struct pel_point d = corner_of(s, ++i);
        border_to(s, p.x + scaled(s, d.x), p.y + scaled(s, d.y));
    }
}

/* round(half v / k), v half of the sum of two directions, 2^29 at most, and k
 * 2^28 times 1 + cos of the turn between them, 2^21 at least: half v is 2^51 at
 * most. */
static int32_t meet(int32_t v, int32_t half, int32_t k)
{
    const uint64_t n = (uint64_t)pel_product(pel_magnitude(v), half);
    const int32_t at = (int32_t)pel_divide(n + (uint32_t)k / 2, (uint32_t)k);
    return v < 0 ? -at : at;
}

/* To where the sides meet, if that is within the limit l: 1 / cos(turn / 2)
 * <= l, and 2 cos(turn / 2)^2 = 1 + cos(turn). */
static void miter(struct pel_stroker *s, struct pel_point p, int32_t side,
                  const struct pel_stroke_line *m,
                  const struct pel_stroke_line *n)
{
    const int64_t cos =
        (pel_product(m->u.x, n->u.x) + pel_product(m->u.y, n->u.y)) >> 30;
    const int32_t k = (1 << 28) + (int32_t)cos;
    if (pel_product(s->limit * s->limit, k) < INT64_C(1) << 45)
        return;
    border_to(s, p.x + side * meet((m->u.y + n->u.y) / 2, s->half, k),
              p.y - side * meet((m->u.x + n->u.x) / 2, s->half, k));
}

/* Both lines cover what lies between the straight line and that by the point,
 * if they are long enough. */
static void inner_side(struct pel_stroker *s, struct pel_point p,
                       struct pel_point from, struct pel_point to,
                       bool straight)
{
    s->border = (struct pel_point){p.x + from.x, p.y + from.y};
    if (!straight)
        border_to(s, p.x, p.y);
    border_to(s, p.x + to.x, p.y + to.y);
}

void pel_stroke_join(struct pel_stroker *s, struct pel_point p,
                     const struct pel_stroke_line *m,
                     const struct pel_stroke_line *n)
{
    if (p.y + s->reach < s->sides->top || p.y - s->reach > s->sides->bottom)
        return;
    const bool right =
        pel_product(m->u.x, n->u.y) >= pel_product(m->u.y, n->u.x);
    const struct pel_point from = right ? m->n : negative(n->n);
    const struct pel_point to = right ? n->n : negative(m->n);
    s->border = (struct pel_point){p.x + from.x, p.y + from.y};
    if (s->stroke->join == PEL_JOIN_ROUND)
        arc(s, p, from, to);
    else if (s->stroke->join == PEL_JOIN_MITER)
        miter(s, p, right ? 1 : -1, m, n);
    border_to(s, p.x + to.x, p.y + to.y);
    inner_side(s, p, negative(to), negative(from), m->is_long && n->is_long);
}

/* From n around the end to the other side. */
static void cap(struct pel_stroker *s, struct pel_point p, struct pel_point n)
{
    s->border = (struct pel_point){p.x + n.x, p.y + n.y};
    if (s->stroke->cap == PEL_CAP_ROUND) {
        arc(s, p, n, negative(n));
    } else if (s->stroke->cap == PEL_CAP_SQUARE) {
        border_to(s, p.x + n.x - n.y, p.y + n.y + n.x);
        border_to(s, p.x - n.x - n.y, p.y - n.y + n.x);
    }
    border_to(s, p.x - n.x, p.y - n.y);
}

void pel_stroke_cap(struct pel_stroker *s, struct pel_point p,
                    const struct pel_stroke_line *line, bool backwards)
{
    cap(s, p, backwards ? negative(line->n) : line->n);
}

void pel_stroke_dot(struct pel_stroker *s, struct pel_point p,
                    const struct pel_stroke_line *line)
{
    if (s->stroke->cap == PEL_CAP_BUTT)
        return;
    cap(s, p, line->n);
    cap(s, p, negative(line->n));
}
