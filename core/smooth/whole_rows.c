/* Rows that sides cross from their upper end to the lower one, apart from each
 * other: many at a time. */
#include "outline.h"

#if !PEL_SMOOTH_TINY

enum { MOST = 4 };

/* The sides of a row, their columns, their bytes, and their order from left to
 * right. Those out of sight take no bytes. */
struct sides {
    struct pel_smooth_visitor visitor; /* first */
    const struct pel_rect *seen;
    int32_t n;
    struct pel_smooth_crossing side[MOST];
    struct pel_span columns[MOST];
    int32_t bytes[MOST];
    uint8_t order[MOST];
};

/* One that does not cross a whole row counts as too many. */
static void place(struct pel_smooth_visitor *sides,
                  struct pel_smooth_crossing *c)
{
    struct sides *const s = (void *)sides;
    const struct pel_span columns = pel_smooth_crossing_columns(c);
    const int32_t n = s->n;
    if (n >= MOST || c->strip.far - c->strip.near != 65536) {
        s->n = MOST + 1;
        return;
    }
    int32_t i = s->n++;
    for (; i > 0 && s->columns[s->order[i - 1]].x0 > columns.x0; i--)
        s->order[i] = s->order[i - 1];
    s->order[i] = (uint8_t)n;
    s->side[n] = *c;
    s->columns[n] = columns;
    s->bytes[n] = columns.x0 < s->seen->x1 && columns.x1 > s->seen->x0
                      ? columns.x1 - columns.x0
                      : 0;
}

/* False: the row is another one. */
static bool find_sides(struct pel_smooth_outline *o, int32_t y, struct sides *s)
{
    int32_t end = INT32_MIN;
    s->n = 0;
    pel_smooth_visit(o, y, &s->visitor);
    if (s->n % 2 == 1 || s->n == 0)
        return false;
    for (int32_t i = 0; i < s->n; i++) {
        const int32_t k = s->order[i];
        if (s->side[k].rising == (i & 1) || end > s->columns[k].x0)
            return false;
        end = s->columns[k].x1;
    }
    return true;
}

/* Writes the coverage of a side's pixels, of what is outside where flip is all
 * ones. */
static void cover(struct pel_smooth_crossing *c, struct pel_span columns,
                  uint8_t *to)
{
    struct pel_smooth_arc_piece piece = {0, 0, INT32_MIN, 0};
    const uint32_t flip = c->left == c->rising ? 0 : ~UINT32_C(0);
    const int32_t step = c->left ? -1 : 1;
    int32_t n = columns.x1 - columns.x0;
    int32_t x = c->left ? -columns.x1 : columns.x0;
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

/* Is side b the image of a, column by column? */
static bool is_image(const struct pel_smooth_crossing *a,
                     const struct pel_smooth_crossing *b)
{
    return a->strip.circle && a->strip.circle == b->strip.circle && a->left &&
           !b->left && ((a->center ^ b->center) & 255) == 0;
}

/* The bytes of side i from the left. */
static void put_side(struct sides *s, int32_t i, uint8_t *to,
                     uint8_t *const from[MOST])
{
    const int32_t k = s->order[i], n = s->bytes[k];
    const int32_t image = s->order[s->n - 1 - i];
    if (2 * i < s->n || s->bytes[image] == 0 ||
        !is_image(&s->side[image], &s->side[k])) {
        if (n > 0)
            cover(&s->side[k], s->columns[k], to);
        return;
    }
    const uint8_t *end = from[s->n - 1 - i] + n;
    for (int32_t left = n; left > 0; left--)
        *to++ = *--end;
}

static void put_sides(struct rows *r, struct sides *s)
{
    uint8_t *from[MOST];
    for (int32_t i = 0; i < s->n; i++) {
        struct pel_smooth_batch *const b = &r->batch[i / 2];
        const int32_t k = s->order[i], at = 2 * b->n + i % 2;
        from[i] = r->to[i / 2];
        r->to[i / 2] += s->bytes[k];
        b->count[at] = (uint8_t)s->bytes[k];
        b->at.x[at] = i % 2 ? s->columns[k].x0 : s->columns[k].x1;
        put_side(s, i, from[i], from);
    }
    r->batch[0].n++;
    r->batch[1].n++;
}

/* Adds a row, if there is room. */
static bool add_row(struct rows *r, struct sides *s)
{
    for (int32_t i = 0; i < s->n; i += 2)
        if (r->to[i / 2] + s->bytes[s->order[i]] + s->bytes[s->order[i + 1]] >
            r->batch[i / 2].coverage + PEL_SMOOTH_BATCH_BYTES)
            return false;
    r->sides = s->n;
    put_sides(r, s);
    return true;
}

static PEL_NOINLINE_32 void find_rows(struct pel_smooth_outline *o, int32_t y,
                                      int32_t end, struct rows *r)
{
    struct sides s;
    s.visitor.visit = place;
    s.seen = &o->seen;
    for (int i = 0; i < 2; i++) {
        r->batch[i].y = y;
        r->batch[i].n = 0;
        r->to[i] = r->batch[i].coverage;
    }
    r->sides = 0;
    while (y < end && r->batch[0].n < PEL_SMOOTH_BATCH_ROWS &&
           find_sides(o, y, &s) && (r->sides == 0 || s.n == r->sides) &&
           add_row(r, &s))
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
