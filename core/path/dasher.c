#include "dasher.h"

#include "../base/divide.h"
#include "../base/sqrt.h"

/* Of lengths, in a sub-pixel. */
enum { UNIT = 32 };

/* Dashes and gaps change places from period to period where they are odd. */
static int32_t index_count(const struct pel_stroke *stroke)
{
    return stroke->dash_count * (1 + stroke->dash_count % 2);
}

static int32_t length_of(const struct pel_stroke *stroke, int32_t index)
{
    return stroke->dash[index % stroke->dash_count] * UNIT;
}

static bool is_dash(const struct pel_dasher *d)
{
    return d->index % 2 == 0;
}

static void next(struct pel_dasher *d)
{
    const struct pel_stroke *const stroke = d->stroker.stroke;
    d->index = d->index + 1 < index_count(stroke) ? d->index + 1 : 0;
    d->left = length_of(stroke, d->index);
}

/* Goes on by a length below the period, to a dash without length, too. */
static void skip(struct pel_dasher *d, int32_t length)
{
    for (; length >= d->left && (length > 0 || !is_dash(d)); next(d))
        length -= d->left;
    d->left -= length;
}

static enum pel_status pass(struct pel_dasher *d, enum pel_verb verb,
                            const struct pel_point *p)
{
    return d->stroker.pen.draw(&d->stroker.pen, verb, p);
}

/* Of legal points: sqrt(2) 2^24 in 1/256 px, times 32, below 2^29.6. */
static int32_t distance(const struct pel_point *a, const struct pel_point *b)
{
    struct pel_root root;
    const uint64_t square =
        (uint64_t)(pel_square(b->x - a->x) + pel_square(b->y - a->y));
    pel_square_root(square * (UNIT * UNIT), &root);
    return (int32_t)root.root;
}

/* round(v along / length), where |v| UNIT and along are at most the length. */
static int32_t part_of(int32_t v, int32_t along, int32_t length)
{
    const uint64_t n = (uint64_t)pel_long_product(pel_magnitude(v), along);
    const int32_t part =
        (int32_t)pel_divide(n + (uint32_t)length / 2, (uint32_t)length);
    return v < 0 ? -part : part;
}

static bool is_seen(const struct pel_dasher *d, const struct pel_point *p)
{
    return pel_max(d->at.y, p->y) >= d->stroker.pen.top &&
           pel_min(d->at.y, p->y) <= d->stroker.pen.bottom;
}

/* Every dash and gap that ends on the line to p. */
static enum pel_status cut_line(struct pel_dasher *d, const struct pel_point *p,
                                int32_t length)
{
    enum pel_status status = PEL_OK;
    int32_t along = 0;
    for (; length - along >= d->left && status == PEL_OK; next(d)) {
        along += d->left;
        const struct pel_point cut = {
            d->at.x + part_of(p->x - d->at.x, along, length),
            d->at.y + part_of(p->y - d->at.y, along, length)};
        status = pass(d, is_dash(d) ? PEL_LINE : PEL_MOVE, &cut);
    }
    d->left -= length - along;
    return status == PEL_OK && is_dash(d) && along < length
               ? pass(d, PEL_LINE, p)
               : status;
}

/* A dash that comes to a line that is not near the rows goes along it, where
 * nothing is seen of it; another may go on from its end. */
static enum pel_status pass_line(struct pel_dasher *d,
                                 const struct pel_point *p, int32_t length)
{
    enum pel_status status = PEL_OK;
    if (is_dash(d))
        status = pass(d, PEL_LINE, p);
    skip(d, length % d->period);
    return status == PEL_OK && is_dash(d) ? pass(d, PEL_MOVE, p) : status;
}

/* Where a part has had no length yet it may become a dot. */
static enum pel_status line_to(struct pel_dasher *d, struct pel_point p)
{
    const int32_t length = distance(&d->at, &p);
    d->stroker.direction = (struct pel_point){p.x - d->at.x, p.y - d->at.y};
    if (length == 0)
        return is_dash(d) && !d->has_length ? pass(d, PEL_LINE, &p) : PEL_OK;
    d->has_length = true;
    const enum pel_status status =
        is_seen(d, &p) ? cut_line(d, &p, length) : pass_line(d, &p, length);
    d->at = p;
    return status;
}

static enum pel_status draw(struct pel_pen *pen, enum pel_verb verb,
                            const struct pel_point *p)
{
    struct pel_dasher *const d = (struct pel_dasher *)(void *)pen;
    if (verb != PEL_CLOSE && p && !pel_stroker_takes(&d->stroker, p))
        return PEL_ERROR_RANGE;
    if (verb == PEL_LINE)
        return line_to(d, *p);
    if (verb == PEL_CLOSE)
        return line_to(d, d->start);
    if (p)
        d->start = d->at = *p;
    d->index = d->start_index;
    d->left = d->start_left;
    d->has_length = false;
    return pass(d, PEL_MOVE, p);
}

static bool set_dashes(struct pel_dasher *d, const struct pel_stroke *stroke)
{
    const int32_t most = PEL_PX(32767), n = index_count(stroke);
    int32_t period = 0;
    for (int32_t i = 0; i < n; i++) {
        const int32_t dash = stroke->dash[i % stroke->dash_count];
        if (dash < 0 || dash > most - period)
            return false;
        period += dash;
    }
    if (period < 256 || stroke->dash_phase < 0 || stroke->dash_phase > most)
        return false;
    d->period = period * UNIT;
    d->index = 0;
    d->left = length_of(stroke, 0);
    skip(d, stroke->dash_phase * UNIT % d->period);
    d->start_index = d->index;
    d->start_left = d->left;
    return true;
}

enum pel_status pel_dasher_begin(struct pel_dasher *d,
                                 const struct pel_stroke *stroke,
                                 struct pel_sides *sides, struct pel_pen **pen)
{
    const enum pel_status status =
        pel_stroker_begin(&d->stroker, stroke, sides);
    *pen = &d->stroker.pen;
    if (status != PEL_OK || stroke->dash_count == 0)
        return status;
    if (!stroke->dash)
        return PEL_ERROR_NULL;
    d->pen = (struct pel_pen){draw, PEL_COORDINATE_MIN, PEL_COORDINATE_MAX};
    *pen = &d->pen;
    return stroke->dash_count > 0 && stroke->dash_count <= 64 &&
                   set_dashes(d, stroke)
               ? PEL_OK
               : PEL_ERROR_RANGE;
}
