/* Rows that sides cross from their upper end to the lower one, apart from each
 * other: many at a time. */
#include "outline.h"

#include <stddef.h>

#if !PEL_SMOOTH_TINY

enum { MOST = 4 };

/* A side, its columns, and the bytes that it takes: none out of sight. */
struct side {
    struct pel_smooth_crossing crossing;
    struct pel_span columns;
    int32_t bytes;
};

/* The sides of a row, and their order from left to right. */
struct sides {
    struct pel_smooth_visitor visitor; /* first */
    const struct pel_rect *seen;
    int32_t n;
    struct side side[MOST], *order[MOST];
};

static bool is_whole(const struct pel_smooth_crossing *c)
{
    return c->strip.far - c->strip.near == 65536;
}

/* One that does not cross a whole row counts as too many. */
static void place(struct pel_smooth_visitor *sides,
                  struct pel_smooth_crossing *c)
{
    struct sides *const s = (void *)sides;
    if (s->n >= MOST || !is_whole(c)) {
        s->n = MOST + 1;
        return;
    }
    struct side *const side = &s->side[s->n];
    side->crossing = *c;
    side->columns = pel_smooth_crossing_columns(c);
    pel_smooth_strip_set(&side->crossing.strip);
    int32_t i = s->n++;
    for (; i > 0 && s->order[i - 1]->columns.x0 > side->columns.x0; i--)
        s->order[i] = s->order[i - 1];
    s->order[i] = side;
}

static int32_t bytes_of(const struct pel_span *columns,
                        const struct pel_rect *seen)
{
    const bool is_seen = columns->x0 < seen->x1 && columns->x1 > seen->x0;
    return is_seen ? columns->x1 - columns->x0 : 0;
}

/* Do sides begin and end the shape in turn, apart from each other? Counts their
 * bytes. */
static bool are_apart(struct sides *s)
{
    int32_t end = INT32_MIN;
    for (int32_t i = 0; i < s->n; i++) {
        struct side *const k = s->order[i];
        if (k->crossing.rising == (i & 1) || end > k->columns.x0)
            return false;
        end = k->columns.x1;
        k->bytes = bytes_of(&k->columns, s->seen);
    }
    return true;
}

/* False: the row is another one. */
static bool find_sides(struct pel_smooth_outline *o, int32_t y, struct sides *s)
{
    s->n = 0;
    pel_smooth_visit(o, y, &s->visitor);
    return s->n > 0 && s->n % 2 == 0 && are_apart(s);
}

/* Moves the strip of a circle on by a row. Where the arc is at the near end of
 * the row above the centre, or at the far end of one below, it has not been cut
 * to the other end, but for where both are equal. */
static void move_down(struct pel_smooth_strip *s, bool below)
{
    const struct pel_smooth_circle *const c = s->circle;
    if (below) {
        s->at_near = s->at_far < s->at_near
                         ? s->at_far
                         : pel_smooth_arc_at(c, s->far >> 8, false);
        s->near = s->far;
        s->far += 65536;
        s->at_far = pel_smooth_arc_at(c, s->far >> 8, false);
    } else {
        s->at_far = s->at_near;
        s->far = s->near;
        s->near -= 65536;
        s->at_near =
            s->near > 0 ? pel_smooth_arc_at(c, s->near >> 8, false) : c->reach;
    }
    s->at_far = pel_min(s->at_far, s->at_near);
    pel_smooth_strip_set(s);
}

/* Goes on to row y, where no side begins or ends. Two sides of one circle have
 * one strip. False: the row is another one. */
static bool move_sides(struct pel_smooth_outline *o, int32_t y, struct sides *s)
{
    const struct pel_smooth_strip *before = NULL;
    for (struct side *side = s->side; side < s->side + s->n; side++) {
        struct pel_smooth_crossing *const c = &side->crossing;
        struct pel_smooth_strip *const strip = &c->strip;
        if (c->other >= 0) {
            if (!o->other(o, y, c->other, c) || !is_whole(c))
                return false;
            pel_smooth_strip_set(strip);
        } else if (before && before->circle == strip->circle) {
            *strip = *before;
        } else {
            move_down(strip, c->below);
        }
        before = strip;
        side->columns = pel_smooth_crossing_columns(c);
    }
    return are_apart(s);
}

/* The row of a height, if that is before *end and not above row y. */
static void note(int32_t height, int32_t y, int32_t *end)
{
    const int32_t row = pel_pixel_of(height);
    if (row >= y)
        *end = pel_min(*end, row);
}

/* Sides that are none of circles begin and end less than 4 sub-pixels from the
 * ends of bows. */
static void note_bow(const struct pel_smooth_outline *o,
                     const struct pel_smooth_bow *b, int32_t y, int32_t *end)
{
    const int32_t top = b->center.y, bottom = top + o->spread.y;
    note(top - b->circle.radius, y, end);
    note(top, y, end);
    note(bottom, y, end);
    note(bottom + b->circle.radius, y, end);
    for (int32_t k = -4; o->cut && k <= 4; k += 8) {
        note(top + (b->from.y >> 8) + k, y, end);
        note(top + (b->to.y >> 8) + k, y, end);
    }
}

/* Where rows end, from y on, in which no side begins or ends. */
static int32_t find_end(const struct pel_smooth_outline *o, int32_t y)
{
    int32_t end = INT32_MAX;
    for (int32_t i = 0; i < o->bows; i++)
        note_bow(o, &o->bow[i], y, &end);
    return end;
}

/* Writes the coverage of a side's pixels, of what is outside where flip is all
 * ones. */
static void cover(const struct pel_smooth_crossing *c, struct pel_span columns,
                  uint8_t *to)
{
    struct pel_smooth_arc_piece piece = {0, 0, INT32_MIN, 0};
    const uint32_t flip = c->left == c->rising ? 0 : ~UINT32_C(0);
    const int32_t step = c->left ? -1 : 1;
    int32_t n = columns.x1 - columns.x0;
    int32_t x = c->left ? -columns.x1 : columns.x0;
    to += c->left ? n - 1 : 0;
    for (; n > 0; n--, x++, to += step) {
        const int32_t u = pel_smooth_boundary(c, x);
        const uint32_t area = pel_smooth_column_area(&c->strip, u, &piece);
        *to = pel_smooth_coverage((area ^ flip) + (flip & 32769));
    }
}

/* Batches of what is between the first two sides, and between the others. */
struct rows {
    struct pel_smooth_batch batch[2];
    uint8_t *to[MOST / 2]; /* where the bytes of the next row go */
    int32_t sides;
};

/* Is side b the image of a, column by column? */
static bool is_image(const struct pel_smooth_crossing *a,
                     const struct pel_smooth_crossing *b)
{
    return a->strip.circle && a->strip.circle == b->strip.circle && a->left &&
           !b->left && ((a->center ^ b->center) & 255) == 0;
}

/* Side i from the left, whose image may have been put at `from`. */
static void put_side(const struct sides *s, int32_t i, uint8_t *to,
                     const uint8_t *from)
{
    const struct side *const k = s->order[i];
    const struct side *const image = s->order[s->n - 1 - i];
    if (2 * i < s->n || image->bytes == 0 ||
        !is_image(&image->crossing, &k->crossing)) {
        cover(&k->crossing, k->columns, to);
        return;
    }
    from += k->bytes;
    for (int32_t n = k->bytes; n > 0; n--)
        *to++ = *--from;
}

static void put_sides(struct rows *r, const struct sides *s)
{
    uint8_t *from[MOST] = {NULL, NULL, NULL, NULL};
    for (int32_t i = 0; i < s->n; i++) {
        struct pel_smooth_batch *const b = &r->batch[i / 2];
        const struct side *const k = s->order[i];
        const int32_t at = 2 * b->n + i % 2;
        from[i] = r->to[i / 2];
        r->to[i / 2] += k->bytes;
        b->count[at] = (uint8_t)k->bytes;
        b->at.x[at] = i % 2 ? k->columns.x0 : k->columns.x1;
        if (k->bytes > 0)
            put_side(s, i, from[i], from[s->n - 1 - i]);
    }
    r->batch[0].n++;
    r->batch[1].n++;
}

/* Adds a row, if there is room. */
static bool add_row(struct rows *r, const struct sides *s)
{
    for (int32_t i = 0; i < s->n; i += 2)
        if (r->to[i / 2] + s->order[i]->bytes + s->order[i + 1]->bytes >
            r->batch[i / 2].coverage + PEL_SMOOTH_BATCH_BYTES)
            return false;
    r->sides = s->n;
    put_sides(r, s);
    return true;
}

static PEL_NOINLINE_32 void find_rows(struct pel_smooth_outline *o, int32_t y,
                                      int32_t end, struct rows *r)
{
    const int32_t alike = find_end(o, y);
    struct sides s;
    s.visitor.visit = place;
    s.seen = &o->seen;
    for (int i = 0; i < 2; i++) {
        r->batch[i].y = y;
        r->batch[i].n = 0;
        r->to[i] = r->batch[i].coverage;
    }
    r->sides = 0;
    while (
        y < end && r->batch[0].n < PEL_SMOOTH_BATCH_ROWS &&
        (r->sides && y < alike ? move_sides(o, y, &s) : find_sides(o, y, &s)) &&
        (r->sides == 0 || s.n == r->sides) && add_row(r, &s))
        y++;
}

static void paint(const struct pel_smooth_outline *o,
                  struct pel_smooth_batch *b)
{
    if (!o->inside)
        pel_smooth_clip_batch(b, &o->smooth.target->clip);
    pel_smooth_paint_batch(&o->smooth, b);
    if (!o->twins)
        return;
    b->n -= 2 * (b->y + b->n - 1) == o->image_y;
    pel_smooth_paint_upwards(&o->smooth, b, o->image_y - b->y);
}

int32_t pel_smooth_whole_rows(struct pel_smooth_outline *o, int32_t y,
                              int32_t end)
{
    struct rows r;
    find_rows(o, y, end, &r);
    const int32_t n = r.batch[0].n;
    for (int32_t i = 0; i < r.sides / 2; i++)
        paint(o, &r.batch[i]);
    return n;
}

#endif
