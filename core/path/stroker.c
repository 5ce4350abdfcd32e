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

/* Of the line to p; a dot that is not of a dash lies to the right. */
static PEL_NOINLINE void set_line(struct pel_stroker *s,
                                  const struct pel_point *p)
{
    struct pel_stroke_line *const line = &s->line;
    const struct pel_point step = {p->x - s->at.x, p->y - s->at.y};
    const bool dashed = s->direction.x || s->direction.y;
    struct pel_point direction = dashed ? s->direction : step;
    int shift;
    if (!direction.x && !direction.y)
        direction.x = 1;
    const uint32_t inverse = pel_inverse_root(
        (uint64_t)(pel_square(direction.x) + pel_square(direction.y)), &shift);
    line->u.x = part_of(direction.x, inverse, shift);
    line->u.y = part_of(direction.y, inverse, shift);
    line->n.x = across(line->u.y, s->half);
    line->n.y = -across(line->u.x, s->half);
    line->is_long =
        pel_magnitude(step.x) >= s->half || pel_magnitude(step.y) >= s->half;
    if (s->stroke->cap == PEL_CAP_ROUND || s->stroke->join == PEL_JOIN_ROUND)
        line->corner = pel_stroke_corner(
            (struct pel_point){line->u.y >> 14, -(line->u.x >> 14)}, s->circle);
}

/* The two sides of the line from s->at to p: the one on the left goes along it,
 * the other one back. */
static PEL_NOINLINE void draw_sides(struct pel_stroker *s,
                                    const struct pel_point *p)
{
    s->p = s->at;
    pel_border_move(s, &s->line, 1);
    s->p = *p;
    pel_border_beside(s, &s->line, 1);
    pel_border_move(s, &s->line, -1);
    s->p = s->at;
    pel_border_beside(s, &s->line, -1);
    pel_border_end(s);
}

/* Lines that are next to each other are drawn, or not, alike near the point
 * between them: where it is near the rows both are. */
static void line_to(struct pel_stroker *s, const struct pel_point *p)
{
    struct pel_stroke_line *const line = &s->line;
    line->seen = s->half > 0 && pel_pen_sees(&s->pen, s->at.y, p->y);
    if (line->seen)
        set_line(s, p);
    if (!s->has_line)
        s->first = *line;
    s->has_point = true;
    if (p->x == s->at.x && p->y == s->at.y)
        return;
    if (line->seen)
        draw_sides(s, p);
    if (s->has_line && s->last.seen && line->seen)
        pel_stroke_join(s, line);
    s->has_line = true;
    s->last = *line;
    s->at = *p;
}

static void end_open(struct pel_stroker *s)
{
    if (s->has_line && s->first.seen)
        pel_stroke_begin(s);
    if (s->has_line && s->last.seen)
        pel_stroke_end(s);
    if (!s->has_line && s->has_point && s->first.seen)
        pel_stroke_dot(s);
}

static void end_closed(struct pel_stroker *s)
{
    line_to(s, &s->start);
    if (!s->has_line && s->first.seen)
        pel_stroke_dot(s);
    if (s->has_line && s->last.seen && s->first.seen)
        pel_stroke_join(s, &s->first);
}

enum pel_status pel_stroker_draw(struct pel_pen *pen, enum pel_verb verb,
                                 const struct pel_point *p)
{
    struct pel_stroker *const s = (struct pel_stroker *)(void *)pen;
    if (verb != PEL_CLOSE && p && !pel_stroker_takes(s, p))
        return PEL_ERROR_RANGE;
    if (verb == PEL_LINE)
        line_to(s, p);
    else if (verb == PEL_CLOSE)
        end_closed(s);
    else
        end_open(s);
    if (verb != PEL_LINE)
        s->has_line = s->has_point = false;
    if (verb == PEL_MOVE && p)
        s->start = s->at = *p;
    return pen->sides->full ? PEL_ERROR_SCRATCH : PEL_OK;
}

/* A circle of N corners whose sides are as far inside of it as the corners are
 * outside: together r (1 - cos(pi / N)), about 5 r / N^2, of which half is at
 * most 1 / 96 px. */
static void choose_circle(struct pel_stroker *s)
{
    s->circle = 3;
    while ((15 * s->half / 16) >> 2 * s->circle > 0)
        s->circle++;
    s->round =
        s->half + ((5 * s->half + (1 << 2 * s->circle)) >> (2 * s->circle + 1));
}

enum pel_status pel_stroker_begin(struct pel_stroker *s,
                                  const struct pel_stroke *stroke,
                                  struct pel_sides *sides)
{
    const int32_t limit = stroke->miter_limit ? stroke->miter_limit : 1024;
    if (!pel_radius_legal(stroke->width) || limit < 256 || limit > 4096 ||
        (uint32_t)stroke->cap > PEL_CAP_ROUND ||
        (uint32_t)stroke->join > PEL_JOIN_ROUND)
        return PEL_ERROR_RANGE;
    s->stroke = stroke;
    s->limit = limit;
    s->half = stroke->width / 2;
    s->reach = s->half + s->half / 2;
    if (stroke->join == PEL_JOIN_MITER)
        s->reach = pel_max(s->reach, ((s->half >> 8) + 1) * limit);
    s->reach += 2;
    s->direction = (struct pel_point){0, 0};
    s->has_line = s->has_point = false;
    s->pen = (struct pel_pen){pel_stroker_draw,
                              sides->top - s->reach,
                              sides->bottom + s->reach,
                              PEL_COORDINATE_MAX - s->reach,
                              sides,
                              s + 1};
    choose_circle(s);
    return PEL_OK;
}

/* Makes the pen, that of the stroke or of dashes. */
static enum pel_status begin(const struct pel_stroke *stroke,
                             struct pel_sides *sides)
{
    const struct pel_dashes *const dashes = stroke->dashes;
    if (!dashes)
        return pel_stroker_begin(sides->memory, stroke, sides);
    return dashes->kind ? dashes->kind->begin(stroke, sides) : PEL_ERROR_NULL;
}

enum pel_status pel_stroke_walk(const void *shape, struct pel_sides *sides)
{
    const struct pel_lines *const lines = shape;
    const enum pel_status status = begin(lines->stroke, sides);
    return status == PEL_OK ? lines->walk(lines->shape, sides->memory) : status;
}
