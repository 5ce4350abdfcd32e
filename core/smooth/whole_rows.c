/* Rows that sides cross from their upper end to the lower one, apart from each
 * other: many at a time. */
#include "outline.h"

#if !PEL_SMOOTH_TINY

enum { MOST = 4 };

/* The sides of a row, from left to right, and their columns. */
struct sides {
    int32_t n;
    struct pel_smooth_crossing side[MOST];
    struct pel_span columns[MOST];
};

static void place(struct sides *s, const struct pel_smooth_crossing *c)
{
    const struct pel_span columns = pel_smooth_crossing_columns(c);
    int32_t i = s->n++;
    for (; i > 0 && s->columns[i - 1].x0 > columns.x0; i--) {
        s->columns[i] = s->columns[i - 1];
        s->side[i] = s->side[i - 1];
    }
    s->columns[i] = columns;
    s->side[i] = *c;
}

/* False: the row is another one. */
static bool find_sides(struct pel_smooth_outline *o, int32_t y, struct sides *s)
{
    const int32_t count = pel_smooth_crossings(o);
    s->n = 0;
    for (int32_t i = 0; i < count; i++) {
        struct pel_smooth_crossing c;
        if (!pel_smooth_crossing_find(o, y, i, &c))
            continue;
        if (s->n == MOST || c.strip.far - c.strip.near != 65536)
            return false;
        place(s, &c);
    }
    for (int32_t i = 0; i < s->n; i++)
        if (s->side[i].rising == (i & 1) ||
            (i > 0 && s->columns[i - 1].x1 > s->columns[i].x0))
            return false;
    return s->n > 0 && s->n % 2 == 0;
}

/* Writes the coverage of a side's pixels, of what is outside where flip is all
 * ones. */
static void cover(struct pel_smooth_crossing *c, struct pel_span columns,
                  uint8_t *to)
{
    struct pel_smooth_arc_piece piece = {0, 0, INT32_MIN, 0};
    const uint32_t flip = c->left == c->rising ? 0 : ~UINT32_C(0);
    const int32_t step = c->left ? -1 : 1;
    int32_t n = columns.x1 - columns.x0, x = c->left ? -columns.x1 : columns.x0;
    to += c->left ? n - 1 : 0;
    pel_smooth_strip_set(&c->strip);
    for (; n > 0; n--, x++, to += step) {
        const int32_t u = (x * 256 - c->center) * 256;
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

/* Bytes that a side takes; one out of sight takes none. */
static int32_t bytes_of(const struct sides *s, int32_t i,
                        const struct pel_rect *seen)
{
    const struct pel_span *const c = &s->columns[i];
    return c->x0 < seen->x1 && c->x1 > seen->x0 ? c->x1 - c->x0 : 0;
}

/* Is side i the image of one on the left, column by column? */
static bool is_image(const struct pel_smooth_crossing *a,
                     const struct pel_smooth_crossing *b)
{
    return a->strip.circle && a->strip.circle == b->strip.circle && a->left &&
           !b->left && ((a->center ^ b->center) & 255) == 0;
}

static void put_sides(struct rows *r, struct sides *s,
                      const struct pel_rect *seen)
{
    uint8_t *from[MOST];
    for (int32_t i = 0; i < s->n; i++) {
        struct pel_smooth_batch *const b = &r->batch[i / 2];
        const int32_t n = bytes_of(s, i, seen), other = s->n - 1 - i;
        from[i] = r->to[i / 2];
        r->to[i / 2] += n;
        b->count[2 * b->n + i % 2] = (uint8_t)n;
        b->at.x[2 * b->n + i % 2] = i % 2 ? s->columns[i].x0 : s->columns[i].x1;
        if (n == 0)
            continue;
        if (other < i && bytes_of(s, other, seen) > 0 &&
            is_image(&s->side[other], &s->side[i]))
            for (int32_t k = 0; k < n; k++)
                from[i][k] = from[other][n - 1 - k];
        else
            cover(&s->side[i], s->columns[i], from[i]);
    }
    r->batch[0].n++;
    r->batch[1].n++;
}

/* Adds a row, if there is room. */
static bool add_row(struct rows *r, struct sides *s,
                    const struct pel_smooth_outline *o)
{
    for (int32_t i = 0; i < s->n; i += 2)
        if (r->to[i / 2] + bytes_of(s, i, &o->seen) +
                bytes_of(s, i + 1, &o->seen) >
            r->batch[i / 2].coverage + PEL_SMOOTH_BATCH_BYTES)
            return false;
    r->sides = s->n;
    put_sides(r, s, &o->seen);
    return true;
}

static PEL_NOINLINE_32 void find_rows(struct pel_smooth_outline *o, int32_t y,
                                      int32_t end, struct rows *r)
{
    struct sides s;
    for (int i = 0; i < 2; i++) {
        r->batch[i].y = y;
        r->batch[i].n = 0;
        r->to[i] = r->batch[i].coverage;
    }
    r->sides = 0;
    while (y < end && r->batch[0].n < PEL_SMOOTH_BATCH_ROWS &&
           find_sides(o, y, &s) && (r->sides == 0 || s.n == r->sides) &&
           add_row(r, &s, o))
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
