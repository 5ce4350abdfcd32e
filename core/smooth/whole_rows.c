/* Rows that sides cross from their upper end to the lower one, apart from each
 * other: many at a time. */
#include "outline.h"
#include "strip_arc.h"

#include <stddef.h>

#if !PEL_SMOOTH_TINY

enum { MOST = 4 };

/* The sides of a row from left to right, and the crossings that have their
 * strips: two of one circle have one. */
struct sides {
    const struct pel_rect *seen; /* or NULL: all of it */
    int32_t row;                 /* of what follows */
    int32_t n, crossings;
    int32_t mirror; /* of four sides, if the last two are the images of the
                       first: columns of both add up to this; or INT32_MIN */
    struct pel_smooth_side *of[MOST]; /* of a crossing of no circle */
    struct pel_smooth_side side[MOST];
    struct pel_smooth_crossing crossing[MOST];
};

static inline void set_bulge(struct pel_smooth_strip *s)
{
    const bool steep = pel_smooth_is_steep(s);
    s->bulge = pel_smooth_pixel_bulge(
        s->circle, (uint32_t)(steep ? s->at_near : s->near) +
                       (uint32_t)(steep ? s->at_far : s->far));
}

/* Sets bulge: of a circle from 40 px on, to the area between its arc and the
 * chord, 2^-23 px, of a piece that goes along an axis for a pixel; or to 0. */
static void begin_strip(struct pel_smooth_strip *s)
{
    const struct pel_smooth_circle *const c = s->circle;
    s->bulge = 0;
    if (c && c->down > 0 && c->down != PEL_SMOOTH_OVAL && c->radius < 65536)
        set_bulge(s);
}

/* Where the circle is at a height in its strip. */
static PEL_ALWAYS_INLINE int32_t width_at(const struct pel_smooth_strip *s,
                                          int32_t height)
{
    return s->bulge ? pel_smooth_width_at(s->circle, height >> 8)
                    : pel_smooth_arc_at(s->circle, height >> 8, false);
}

/* Moves the strip of a circle on by a row.
 * Where the arc is at the near end of the row above the centre, or at the far
 * end of one below, it has not been cut to the other end, but for where both
 * are equal. */
static PEL_INLINE_LOOP void move_down(struct pel_smooth_strip *s, bool below)
{
    int32_t far = s->at_near, near = s->at_far;
    if (below) {
        if (near == far)
            near = width_at(s, s->far);
        s->near = s->far;
        s->far += 65536;
        far = width_at(s, s->far);
    } else {
        s->far = s->near;
        s->near -= 65536;
        near = s->near > 0 ? width_at(s, s->near) : pel_smooth_reach(s->circle);
    }
    s->at_near = near;
    s->at_far = pel_min(far, near);
    if (s->bulge)
        set_bulge(s);
}

/* Puts a side where it is from left to right. */
static void place(struct sides *s, const struct pel_smooth_crossing *c,
                  const struct pel_smooth_strip *strip)
{
    const int32_t x = pel_smooth_crossing_columns(c).x0;
    struct pel_smooth_side *k = s->side + s->n++;
    for (; k > s->side && k[-1].x > x; k--)
        *k = k[-1];
    k->strip = strip;
    k->center = c->center;
    k->x = x;
    k->flip = c->left == c->rising ? 0 : ~UINT32_C(0);
    k->more = (k->flip & 32769) + 64;
    k->step = c->left ? -1 : 1;
    k->rising = c->rising;
}

/* Is side b the image of a, column by column? */
static bool is_mirror(const struct pel_smooth_side *a,
                      const struct pel_smooth_side *b)
{
    return a < b && a->strip == b->strip && a->step < b->step &&
           ((a->center ^ b->center) & 255) == 0;
}

/* The sides of crossings, each of which crosses a whole row. */
static void place_all(struct sides *s, int32_t n)
{
    struct pel_smooth_crossing *own = s->crossing;
    for (s->n = 0; s->n < n;) {
        const struct pel_smooth_crossing c = s->crossing[s->n];
        own +=
            s->n > 0 && (c.other >= 0 || c.strip.circle != own->strip.circle);
        *own = c;
        begin_strip(&own->strip);
        place(s, &c, &own->strip);
    }
    s->crossings = (int32_t)(own + 1 - s->crossing);
}

static int32_t mirror_of(const struct sides *s)
{
    const struct pel_smooth_side *const k = s->side;
    const int32_t sum = k[s->n - 1].center - k[0].center;
    const bool both = s->n == MOST && k[2].image && k[3].image &&
                      k[2].center - k[1].center == sum;
    return both && !s->seen ? sum >> 8 : INT32_MIN;
}

/* Finds the sides of row y. False: they are not 2 or 4 that cross all of it. */
static bool find_sides(struct pel_smooth_outline *o, int32_t y, struct sides *s)
{
    const int32_t n = pel_smooth_find_crossings(o, y, 0, MOST, s->crossing);
    if (n == 0 || n > MOST || n % 2)
        return false;
    for (int32_t i = 0; i < n; i++)
        if (pel_smooth_height(&s->crossing[i].strip) < 32768)
            return false;
    place_all(s, n);
    for (int32_t i = 0; i < n; i++) {
        struct pel_smooth_side *const k = &s->side[i];
        const struct pel_smooth_side *const other = &s->side[s->n - 1 - i];
        if (k->rising == (i & 1))
            return false;
        k->image = is_mirror(other, k) ? other : NULL;
        for (int32_t j = 0; !k->strip->circle && j < s->crossings; j++)
            if (k->strip == &s->crossing[j].strip)
                s->of[j] = k;
    }
    s->mirror = mirror_of(s);
    return true;
}

/* Goes on to the next row, where no side begins or ends. */
static void move_sides(struct pel_smooth_outline *o, struct sides *s)
{
    struct pel_smooth_crossing *c = s->crossing, *const end = c + s->crossings;
    for (struct pel_smooth_side *const *of = s->of; c < end; c++, of++) {
        if (c->other < 0) {
            move_down(&c->strip, c->below);
            continue;
        }
        o->sides->down(o, c->other, c);
        (*of)->center = c->center;
    }
}

/* What is between two sides, and where the bytes of the next row go. */
struct pair {
    uint8_t *to;
    struct pel_smooth_batch batch;
};

/* What is between the first two sides, and between the other two. */
struct rows {
    int32_t sides, mirror; /* as of all its rows */
    struct pair pair[MOST / 2];
};

/* Writes n bytes of a side, and returns where they end. */
static inline uint8_t *put_side(struct pel_smooth_side *k, int32_t n,
                                uint8_t *to)
{
    const struct pel_smooth_side *const image = k->image;
    k->at = to;
    k->bytes = n;
    if (n == 0)
        return to;
    if (!image || image->bytes == 0) {
        pel_smooth_side_cover(k, to);
        return to + n;
    }
    for (const uint8_t *from = image->at + n; n > 0; n--)
        *to++ = *--from;
    return to;
}

/* The columns of a side. */
static inline struct pel_span columns_of(const struct pel_smooth_side *k)
{
    const struct pel_span c = pel_smooth_crossed(k->strip, k->center);
    const struct pel_span left = {-c.x1, -c.x0};
    return k->step < 0 ? left : c;
}

/* How many of them get bytes. */
static inline int32_t bytes_of(const struct pel_span *columns,
                               const struct pel_rect *seen)
{
    const bool away =
        seen && (columns->x0 >= seen->x1 || columns->x1 <= seen->x0);
    return away ? 0 : columns->x1 - columns->x0;
}

/* Adds a row of two sides, if they are apart, right of x, and there is room:
 * where they end; or INT32_MIN. */
static int32_t put_pair(struct pair *p, struct pel_smooth_side *k,
                        const struct pel_rect *seen, int32_t x)
{
    struct pel_smooth_batch *const b = &p->batch;
    const struct pel_span c0 = columns_of(&k[0]), c1 = columns_of(&k[1]);
    const int32_t n0 = bytes_of(&c0, seen), n1 = bytes_of(&c1, seen);
    if (c0.x0 < x || c1.x0 < c0.x1 ||
        n0 + n1 > b->coverage + PEL_SMOOTH_BATCH_BYTES - p->to)
        return INT32_MIN;
    const int32_t i = 2 * b->n++;
    b->count[i] = (uint8_t)n0;
    b->count[i + 1] = (uint8_t)n1;
    b->at.x[i] = c0.x1;
    b->at.x[i + 1] = c1.x0;
    p->to = put_side(&k[1], n1, put_side(&k[0], n0, p->to));
    return c1.x1;
}

/* Adds a row, if its sides are apart and there is room. */
static bool add_row(struct rows *r, struct sides *s)
{
    const int32_t x = put_pair(&r->pair[0], &s->side[0], s->seen, INT32_MIN);
    if (x == INT32_MIN)
        return false;
    if (s->mirror != INT32_MIN ? 2 * x <= s->mirror
                               : s->n == 2 || put_pair(&r->pair[1], &s->side[2],
                                                       s->seen, x) > INT32_MIN)
        return true;
    r->pair[0].batch.n--;
    return false;
}

/* Goes to row y. False: its sides are not whole. */
static PEL_NOINLINE_32 bool go_to(struct pel_smooth_outline *o, int32_t y,
                                  struct sides *s)
{
    if (s->row == y)
        return true;
    if (y > pel_pixel_of(o->alike))
        o->alike = pel_smooth_find_end(o, y);
    const int32_t end = pel_pixel_of(o->alike);
    const bool moves = s->row == y - 1 && y < end;
    s->row = INT32_MIN;
    if (y == end && (o->alike & 255) > 0)
        return false;
    if (moves)
        move_sides(o, s);
    else if (!find_sides(o, y, s))
        return false;
    s->row = y;
    return true;
}

/* The same where row y - 1 has been. */
static inline bool go_down(struct pel_smooth_outline *o, int32_t y,
                           struct sides *s)
{
    if (y >= pel_pixel_of(o->alike))
        return go_to(o, y, s);
    move_sides(o, s);
    s->row = y;
    return true;
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
    r->mirror = s->mirror;
    while (s->n == r->sides && s->mirror == r->mirror && add_row(r, s))
        if (++n == last || !go_down(o, y + n, s))
            break;
    return n;
}

/* Sets n rows to the mirror image of others. */
static PEL_NOINLINE_32 void reflect(const struct pel_smooth_batch *from,
                                    int32_t n, int32_t mirror,
                                    struct pel_smooth_batch *to)
{
    const uint8_t *end = from->coverage, *of = from->count;
    const int32_t *x = from->at.x;
    uint8_t *byte = to->coverage;
    to->n = n;
    for (int32_t i = 0; i < 2 * n; i += 2) {
        const uint8_t *const begin = end;
        to->at.x[i] = mirror - x[i + 1];
        to->at.x[i + 1] = mirror - x[i];
        to->count[i] = of[i + 1];
        to->count[i + 1] = of[i];
        end += of[i] + of[i + 1];
        for (const uint8_t *k = end; k > begin;)
            *byte++ = *--k;
    }
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
    s.seen = o->inside ? NULL : &o->seen;
    s.row = INT32_MIN;
    do {
        n = find_rows(o, y + rows, end, &s, &r);
        for (int32_t i = 0; n > 0 && i < r.sides / 2; i++) {
            if (i > 0 && r.mirror != INT32_MIN)
                reflect(&r.pair[0].batch, n, r.mirror, &r.pair[1].batch);
            paint(o, &r.pair[i].batch);
        }
        rows += n;
    } while (n > 0 && s.row >= y);
    return rows;
}

#endif
