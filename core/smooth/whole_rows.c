/* Rows that sides cross from their upper end to the lower one, apart from each
 * other: many at a time. */
#include "line_side.h"
#include "outline.h"

#include <stddef.h>

#if !PEL_SMOOTH_TINY

enum { MOST = 4 };

/* The sides of a row from left to right, and what they are sides of: two of one
 * circle have one strip. */
struct sides {
    struct pel_smooth_visitor visitor; /* first */
    const struct pel_rect *seen;       /* or NULL: all of it */
    int32_t row;                       /* of what follows */
    int32_t n, crossings;
    struct pel_smooth_side side[MOST];
    struct pel_smooth_crossing crossing[MOST];
};

static bool is_whole(const struct pel_smooth_crossing *c)
{
    return c->strip.far - c->strip.near == 65536;
}

/* The strip of a side. */
static const struct pel_smooth_strip *strip_of(
    struct sides *s, const struct pel_smooth_crossing *c)
{
    struct pel_smooth_crossing *to = &s->crossing[s->crossings];
    if (s->crossings && c->other < 0 && to[-1].strip.circle == c->strip.circle)
        return &to[-1].strip;
    s->crossings++;
    *to = *c;
    return &to->strip;
}

/* Puts a side where it is from left to right. One that does not cross a whole
 * row counts as too many. */
static void place(struct pel_smooth_visitor *sides)
{
    struct sides *const s = (void *)sides;
    const struct pel_smooth_crossing *const c = &sides->crossing;
    if (s->n >= MOST || !is_whole(c)) {
        s->n = MOST + 1;
        return;
    }
    const struct pel_span columns = pel_smooth_crossing_columns(c);
    struct pel_smooth_side *k = s->side + s->n++;
    for (; k > s->side && k[-1].columns.x0 > columns.x0; k--)
        *k = k[-1];
    k->strip = strip_of(s, c);
    k->center = c->center;
    k->columns = columns;
    k->left = c->left;
    k->rising = c->rising;
    k->flip = c->left == c->rising ? 0 : ~UINT32_C(0);
}

/* Is side b the image of a, column by column? */
static bool is_mirror(const struct pel_smooth_side *a,
                      const struct pel_smooth_side *b)
{
    return a < b && a->strip == b->strip && a->left && !b->left &&
           ((a->center ^ b->center) & 255) == 0;
}

/* Finds the sides of row y. False: they are not 2 or 4 that cross all of it. */
static bool find_sides(struct pel_smooth_outline *o, int32_t y, struct sides *s)
{
    s->n = s->crossings = 0;
    pel_smooth_visit(o, y, &s->visitor);
    if (s->n == 0 || s->n > MOST || s->n % 2)
        return false;
    for (int32_t i = 0; i < s->n; i++) {
        struct pel_smooth_side *const k = &s->side[i];
        const struct pel_smooth_side *const other = &s->side[s->n - 1 - i];
        if (k->rising == (i & 1))
            return false;
        k->image = is_mirror(other, k) ? other : NULL;
    }
    for (int32_t i = 0; i < s->crossings; i++)
        pel_smooth_strip_begin(&s->crossing[i].strip);
    return true;
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
}

/* Goes on to row y, where no side begins or ends. False: one does not cross all
 * of it. */
static bool move_sides(struct pel_smooth_outline *o, int32_t y, struct sides *s)
{
    for (int32_t i = 0; i < s->crossings; i++) {
        struct pel_smooth_crossing *const c = &s->crossing[i];
        if (c->other < 0) {
            move_down(&c->strip, c->below);
            if (c->strip.bulge)
                c->strip.bulge = pel_smooth_pixel_bulge(&c->strip);
            continue;
        }
        if (!o->sides->other(o, y, c->other, c) || !is_whole(c))
            return false;
        for (int32_t k = 0; k < s->n; k++)
            if (s->side[k].strip == &c->strip)
                s->side[k].center = c->center;
    }
    return true;
}

/* Makes *end the row of a height, if that is earlier, but not above row y. */
static void note(int32_t height, int32_t y, int32_t *end)
{
    const int32_t row = pel_pixel_of(height);
    if (row >= y)
        *end = pel_min(*end, row);
}

/* Sides that are none of circles begin and end less than 4 sub-pixels from the
 * ends of curves. */
static void note_curve(const struct pel_smooth_outline *o, int32_t i, int32_t y,
                       int32_t *end)
{
    const struct pel_smooth_curve *const curve = &o->curve[i];
    const int32_t top = curve->center.y, bottom = top + o->spread.y;
    note(top - curve->circle.radius, y, end);
    note(top, y, end);
    note(bottom, y, end);
    note(bottom + curve->circle.radius, y, end);
    if (!o->sides || !o->sides->cut)
        return;
    const struct pel_smooth_ends *const ends = pel_smooth_ends_of(o, i);
    for (int32_t k = -4; k <= 4; k += 8) {
        note(top + (ends->from.y >> 8) + k, y, end);
        note(top + (ends->to.y >> 8) + k, y, end);
    }
}

/* Where rows end, from y on, in which no side begins or ends. */
static int32_t find_end(const struct pel_smooth_outline *o, int32_t y)
{
    int32_t end = INT32_MAX;
    for (int32_t i = 0; i < o->curves; i++)
        note_curve(o, i, y, &end);
    return end;
}

/* What is between two sides, and where the bytes of the next row go. */
struct pair {
    uint8_t *to;
    struct pel_smooth_batch batch;
};

/* What is between the first two sides, and between the other two. */
struct rows {
    int32_t sides;
    struct pair pair[MOST / 2];
};

/* Writes the bytes of a side, and returns where they end. */
static inline uint8_t *put_side(struct pel_smooth_side *k, uint8_t *to)
{
    int32_t n = k->bytes;
    k->at = to;
    if (n == 0)
        return to;
    if (!k->image || k->image->bytes == 0) {
        pel_smooth_side_cover(k, to);
        return to + n;
    }
    for (const uint8_t *from = k->image->at + n; n > 0; n--)
        *to++ = *--from;
    return to;
}

/* Finds the columns of a side, which lie right of x: where they end. */
static inline bool find_columns(struct pel_smooth_side *k,
                                const struct pel_rect *seen, int32_t x)
{
    struct pel_span c = pel_smooth_crossed(k->strip, k->center);
    k->u = (c.x0 * 256 - k->center) * 256;
    if (k->left)
        c = (struct pel_span){-c.x1, -c.x0};
    k->columns = c;
    k->bytes = c.x1 - c.x0;
    if (seen && (c.x0 >= seen->x1 || c.x1 <= seen->x0))
        k->bytes = 0;
    return c.x0 >= x;
}

/* Adds a row of two sides, if they are apart, right of x, and there is room. */
static bool put_pair(struct pair *p, struct pel_smooth_side *k,
                     const struct pel_rect *seen, int32_t x)
{
    struct pel_smooth_batch *const b = &p->batch;
    if (!find_columns(&k[0], seen, x) ||
        !find_columns(&k[1], seen, k[0].columns.x1) ||
        k[0].bytes + k[1].bytes > b->coverage + PEL_SMOOTH_BATCH_BYTES - p->to)
        return false;
    const int32_t at = 2 * b->n++;
    b->count[at] = (uint8_t)k[0].bytes;
    b->count[at + 1] = (uint8_t)k[1].bytes;
    b->at.x[at] = k[0].columns.x1;
    b->at.x[at + 1] = k[1].columns.x0;
    p->to = put_side(&k[1], put_side(&k[0], p->to));
    return true;
}

/* Adds a row, if its sides are apart and there is room. */
static bool add_row(struct rows *r, struct sides *s)
{
    if (!put_pair(&r->pair[0], &s->side[0], s->seen, INT32_MIN))
        return false;
    if (s->n > 2 &&
        !put_pair(&r->pair[1], &s->side[2], s->seen, s->side[1].columns.x1)) {
        r->pair[0].batch.n--;
        return false;
    }
    return true;
}

/* Goes to row y. False: its sides are not whole. */
static PEL_NOINLINE_32 bool go_to(struct pel_smooth_outline *o, int32_t y,
                                  struct sides *s)
{
    if (s->row == y)
        return true;
    if (y > o->alike)
        o->alike = find_end(o, y);
    const bool moves = s->row == y - 1 && y < o->alike;
    s->row = INT32_MIN;
    if (!(moves ? move_sides(o, y, s) : find_sides(o, y, s)))
        return false;
    s->row = y;
    return true;
}

/* The same where row y - 1 has been. */
static inline bool go_down(struct pel_smooth_outline *o, int32_t y,
                           struct sides *s)
{
    if (y >= o->alike)
        return go_to(o, y, s);
    s->row = move_sides(o, y, s) ? y : INT32_MIN;
    return s->row == y;
}

/* Makes batches of the rows from y on: returns their number. */
static PEL_NOINLINE_32 int32_t find_rows(struct pel_smooth_outline *o,
                                         int32_t y, int32_t end,
                                         struct sides *s, struct rows *r)
{
    const int32_t last = pel_min(end - y, PEL_SMOOTH_BATCH_ROWS);
    int32_t n = 0;
    for (int i = 0; i < 2; i++) {
        r->pair[i].batch.y = y;
        r->pair[i].batch.n = 0;
        r->pair[i].to = r->pair[i].batch.coverage;
    }
    if (last <= 0 || !go_to(o, y, s))
        return 0;
    r->sides = s->n;
    while (s->n == r->sides && add_row(r, s))
        if (++n == last || !go_down(o, y + n, s))
            break;
    return n;
}

static void paint(const struct pel_smooth_outline *o,
                  struct pel_smooth_batch *b)
{
    if (!o->inside)
        pel_smooth_clip_batch(b, &o->smooth.target->clip);
    pel_smooth_paint_batch(&o->smooth, b);
    if (!o->mirrored)
        return;
    b->n -= 2 * (b->y + b->n - 1) == o->mirror_y;
    pel_smooth_paint_upwards(&o->smooth, b, o->mirror_y - b->y);
}

int32_t pel_smooth_whole_rows(struct pel_smooth_outline *o, int32_t y,
                              int32_t end)
{
    struct rows r;
    struct sides s;
    int32_t rows = 0, n;
    s.visitor.visit = place;
    s.seen = o->inside ? NULL : &o->seen;
    s.row = INT32_MIN;
    do {
        n = find_rows(o, y + rows, end, &s, &r);
        for (int32_t i = 0; n > 0 && i < r.sides / 2; i++)
            paint(o, &r.pair[i].batch);
        rows += n;
    } while (n > 0 && s.row >= y);
    return rows;
}

#endif
