#include "stroker.h"

#include "../base/sqrt.h"

/* v 2^29 / length, towards 0; inverse and shift of pel_inverse_root(length^2).
 * |v| is at most the length. */
static int32_t part_of(int32_t v, uint32_t inverse, int shift)
{
    const uint64_t part =
        pel_multiply((uint32_t)pel_magnitude(v), inverse) >> (33 - shift);
    return v < 0 ? -(int32_t)part : (int32_t)part;
}

/* round(u half / 2^29), away from 0 at a tie. */
static int32_t across(int32_t u, int32_t half)
{
    const int64_t n = (pel_product(pel_magnitude(u), half) + (1 << 28)) >> 29;
    return u < 0 ? -(int32_t)n : (int32_t)n;
}

static int64_t square_of(struct pel_point v)
{
    return pel_square(v.x) + pel_square(v.y);
}

/* Of the line to p; a dot that is not of a dash lies to the right. */
static void set_line(const struct pel_stroker *s, struct pel_stroke_line *line,
                     struct pel_point p)
{
    const struct pel_point step = {p.x - s->at.x, p.y - s->at.y};
    struct pel_point direction = square_of(s->direction) ? s->direction : step;
    int shift;
    if (square_of(direction) == 0)
        direction.x = 1;
    const uint32_t inverse =
        pel_inverse_root((uint64_t)square_of(direction), &shift);
    line->u.x = part_of(direction.x, inverse, shift);
    line->u.y = part_of(direction.y, inverse, shift);
    line->n.x = across(line->u.y, s->half);
    line->n.y = -across(line->u.x, s->half);
    line->is_long = square_of(step) >= pel_square(s->half);
}

/* Its two sides: the one on the left goes along it, the other one back. */
static void draw_sides(struct pel_stroker *s, struct pel_point a,
                       struct pel_point b, struct pel_point n)
{
    pel_stroke_side(s, (struct pel_point){a.x + n.x, a.y + n.y},
                    (struct pel_point){b.x + n.x, b.y + n.y});
    pel_stroke_side(s, (struct pel_point){b.x - n.x, b.y - n.y},
                    (struct pel_point){a.x - n.x, a.y - n.y});
}

static bool is_seen(const struct pel_stroker *s, struct pel_point a,
                    struct pel_point b)
{
    return pel_max(a.y, b.y) + s->reach >= s->sides->top &&
           pel_min(a.y, b.y) - s->reach <= s->sides->bottom;
}

/* Lines that are next to each other are drawn, or not, alike near the point
 * between them: where it is near the rows both are. */
static void line_to(struct pel_stroker *s, struct pel_point p)
{
    struct pel_stroke_line line = {.seen = s->half > 0 && is_seen(s, s->at, p)};
    if (line.seen)
        set_line(s, &line, p);
    if (!s->has_line)
        s->first = line;
    s->has_point = true;
    if (p.x == s->at.x && p.y == s->at.y)
        return;
    if (line.seen)
        draw_sides(s, s->at, p, line.n);
    if (s->has_line && s->last.seen && line.seen)
        pel_stroke_join(s, s->at, &s->last, &line);
    s->has_line = true;
    s->last = line;
    s->at = p;
}

static void end_open(struct pel_stroker *s)
{
    if (s->has_line && s->first.seen)
        pel_stroke_cap(s, s->start, &s->first, true);
    if (s->has_line && s->last.seen)
        pel_stroke_cap(s, s->at, &s->last, false);
    if (!s->has_line && s->has_point && s->first.seen)
        pel_stroke_dot(s, s->start, &s->first);
    s->has_line = s->has_point = false;
}

static void end_closed(struct pel_stroker *s)
{
    line_to(s, s->start);
    if (!s->has_line && s->first.seen)
        pel_stroke_dot(s, s->start, &s->first);
    if (s->has_line && s->last.seen && s->first.seen)
        pel_stroke_join(s, s->start, &s->last, &s->first);
    s->has_line = s->has_point = false;
}

static enum pel_status draw(struct pel_pen *pen, enum pel_verb verb,
                            const struct pel_point *p)
{
    struct pel_stroker *const s = (struct pel_stroker *)(void *)pen;
    if (verb != PEL_CLOSE && p && !pel_stroker_takes(s, p))
        return PEL_ERROR_RANGE;
    if (verb == PEL_LINE)
        line_to(s, *p);
    else if (verb == PEL_CLOSE)
        end_closed(s);
    else
        end_open(s);
    if (verb == PEL_MOVE && p)
        s->start = s->at = *p;
    return s->room ? PEL_OK : PEL_ERROR_SCRATCH;
}

/* A circle of N corners whose sides are as far inside of it as the corners are
 * outside: together r (1 - cos(pi / N)), about 5 r / N^2, of which half is at
 * most 1 / 128 px. */
static void choose_circle(struct pel_stroker *s)
{
    s->circle = 3;
    while ((5 * s->half / 4) >> 2 * s->circle > 0)
        s->circle++;
    const int32_t square = 1 << 2 * s->circle;
    s->round = s->half + (5 * s->half + square) / (2 * square);
}

enum pel_status pel_stroker_begin(struct pel_stroker *s,
                                  const struct pel_stroke *stroke,
                                  struct pel_sides *sides)
{
    const int32_t limit = stroke->miter_limit ? stroke->miter_limit : 1024;
    *s = (struct pel_stroker){.sides = sides, .stroke = stroke, .limit = limit};
    if (!pel_radius_legal(stroke->width) || limit < 256 || limit > 4096 ||
        (uint32_t)stroke->cap > PEL_CAP_ROUND ||
        (uint32_t)stroke->join > PEL_JOIN_ROUND)
        return PEL_ERROR_RANGE;
    s->half = stroke->width / 2;
    s->reach = s->half + s->half / 2;
    if (stroke->join == PEL_JOIN_MITER)
        s->reach = pel_max(s->reach, (s->half / 256 + 1) * limit);
    s->reach += 2;
    s->room = true;
    s->pen =
        (struct pel_pen){draw, sides->top - s->reach, sides->bottom + s->reach};
    choose_circle(s);
    return PEL_OK;
}
