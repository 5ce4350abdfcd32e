/* The pen that cuts lines into dashes, before that of the stroke. */
#include "../base/sqrt.h"
#include "stroker.h"

/* Of lengths, in a sub-pixel. */
enum { UNIT = 32 };

struct dasher {
    struct pel_pen pen;
    struct pel_stroker stroker; /* draws the dashes */
    int32_t period;             /* of all dashes and gaps, 1/8192 px */
    struct pel_point start, at; /* where the part began; the latest point */

    /* The present dash or gap where a part begins, and here: what is left of
     * it, 1/8192 px, and its index, even for a dash. */
    int32_t start_left, left;
    uint8_t start_index, index;
    bool has_length;       /* this part, up to here */
    struct pel_point cut;  /* where the latest one ended on a line, */
    int32_t length, along; /* of this length, so far along it */
};

PEL_STATIC_ASSERT(pel_pens_fit,
                  sizeof(struct dasher) + sizeof(struct pel_path_state) <=
                      PEL_PENS_SIZE);

/* Dashes and gaps change places from period to period where they are odd. */
static int32_t index_count(const struct pel_dashes *dashes)
{
    return dashes->count * (1 + dashes->count % 2);
}

static int32_t length_of(const struct pel_dashes *dashes, int32_t index)
{
    return dashes->length[index % dashes->count] * UNIT;
}

static bool is_dash(const struct dasher *d)
{
    return d->index % 2 == 0;
}

static void next(struct dasher *d)
{
    const struct pel_dashes *const dashes = d->stroker.stroke->dashes;
    d->index = (uint8_t)(d->index + 1 < index_count(dashes) ? d->index + 1 : 0);
    d->left = length_of(dashes, d->index);
}

/* Goes on by a length below the period, to a dash without length, too. */
static void skip(struct dasher *d, int32_t length)
{
    for (; length >= d->left && (length > 0 || !is_dash(d)); next(d))
        length -= d->left;
    d->left -= length;
}

static enum pel_status pass(struct dasher *d, enum pel_verb verb,
                            const struct pel_point *p)
{
    return pel_stroker_draw(&d->stroker.pen, verb, p);
}

/* Of legal points: sqrt(2) 2^24 in 1/256 px, times 32, below 2^29.6. */
static PEL_NOINLINE_32 int32_t distance(const struct pel_point *a,
                                        const struct pel_point *b)
{
    struct pel_root root;
    const uint64_t square =
        (uint64_t)(pel_square(b->x - a->x) + pel_square(b->y - a->y));
    pel_square_root(square * (UNIT * UNIT), &root);
    return (int32_t)root.root;
}

/* Sets the end that is so far along the line to p. */
static PEL_NOINLINE_32 void set_cut(struct dasher *d, const struct pel_point *p)
{
    d->cut.x = d->at.x + pel_stroke_part(p->x - d->at.x, d->along, d->length);
    d->cut.y = d->at.y + pel_stroke_part(p->y - d->at.y, d->along, d->length);
}

/* Every dash and gap that ends on the line to p. */
static enum pel_status cut_line(struct dasher *d, const struct pel_point *p)
{
    enum pel_status status = PEL_OK;
    d->along = 0;
    for (; d->length - d->along >= d->left && status == PEL_OK; next(d)) {
        d->along += d->left;
        set_cut(d, p);
        status = pass(d, is_dash(d) ? PEL_LINE : PEL_MOVE, &d->cut);
    }
    d->left -= d->length - d->along;
    return status == PEL_OK && is_dash(d) && d->along < d->length
               ? pass(d, PEL_LINE, p)
               : status;
}

/* A dash that comes to a line that is not near the rows goes along it, where
 * nothing is seen of it; another may go on from its end. */
static enum pel_status pass_line(struct dasher *d, const struct pel_point *p)
{
    enum pel_status status = PEL_OK;
    if (is_dash(d))
        status = pass(d, PEL_LINE, p);
    skip(d, d->length % d->period);
    return status == PEL_OK && is_dash(d) ? pass(d, PEL_MOVE, p) : status;
}

/* Where a part has had no length yet it may become a dot. */
static enum pel_status line_to(struct dasher *d, const struct pel_point *p)
{
    d->length = distance(&d->at, p);
    d->stroker.direction = (struct pel_point){p->x - d->at.x, p->y - d->at.y};
    if (d->length == 0)
        return is_dash(d) && !d->has_length ? pass(d, PEL_LINE, p) : PEL_OK;
    d->has_length = true;
    const bool seen = pel_pen_sees(&d->stroker.pen, d->at.y, p->y);
    const enum pel_status status = seen ? cut_line(d, p) : pass_line(d, p);
    d->at = *p;
    return status;
}

static enum pel_status draw(struct pel_pen *pen, enum pel_verb verb,
                            const struct pel_point *p)
{
    struct dasher *const d = (struct dasher *)(void *)pen;
    if (verb != PEL_CLOSE && p && !pel_stroker_takes(&d->stroker, p))
        return PEL_ERROR_RANGE;
    if (verb != PEL_MOVE)
        return line_to(d, verb == PEL_CLOSE ? &d->start : p);
    if (p)
        d->start = d->at = *p;
    d->index = d->start_index;
    d->left = d->start_left;
    d->has_length = false;
    return pass(d, PEL_MOVE, p);
}

static bool set_dashes(struct dasher *d, const struct pel_dashes *dashes)
{
    const int32_t most = PEL_PX(32767);
    int32_t period = 0;
    if (dashes->count < 1 || dashes->count > 64)
        return false;
    for (int32_t i = 0; i < index_count(dashes); i++) {
        const int32_t length = dashes->length[i % dashes->count];
        if (length < 0 || length > most - period)
            return false;
        period += length;
    }
    if (period < 256 || dashes->phase < 0 || dashes->phase > most)
        return false;
    d->period = period * UNIT;
    d->index = 0;
    d->left = length_of(dashes, 0);
    skip(d, dashes->phase * UNIT % d->period);
    d->start_index = d->index;
    d->start_left = d->left;
    return true;
}

static enum pel_status begin(const struct pel_stroke *stroke,
                             struct pel_sides *sides)
{
    struct dasher *const d = sides->memory;
    const enum pel_status status =
        pel_stroker_begin(&d->stroker, stroke, sides);
    if (status != PEL_OK)
        return status;
    if (!stroke->dashes->length)
        return PEL_ERROR_NULL;
    d->pen = (struct pel_pen){draw,
                              PEL_COORDINATE_MIN,
                              PEL_COORDINATE_MAX,
                              d->stroker.pen.most,
                              sides,
                              d + 1};
    return set_dashes(d, stroke->dashes) ? PEL_OK : PEL_ERROR_RANGE;
}

const struct pel_dash_kind pel_dashed = {begin};
