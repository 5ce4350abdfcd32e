#include "outline.h"

/* Columns whose areas are summed at a time. */
enum { COLUMNS = PEL_SMOOTH_TINY ? 8 : 16 };

void pel_smooth_bow_set(struct pel_smooth_bow *b, int32_t radius)
{
    pel_smooth_circle_set(&b->circle, radius);
    b->row = INT32_MAX;
}

bool pel_smooth_outline_begin(struct pel_smooth_outline *o,
                              const struct pel_surface *surface,
                              const struct pel_rect *box,
                              const struct pel_paint *paint)
{
    const struct pel_rect *const clip = &surface->clip;
    o->seen = pel_rect_intersect(box, clip);
    if (!PEL_SMOOTH_TINY) {
        o->inside = box->x0 >= clip->x0 && box->x1 <= clip->x1;
        o->twins &= box->y0 >= clip->y0 && box->y1 <= clip->y1;
        o->image_y = box->y0 + box->y1 - 1;
        o->alike = INT32_MIN;
    }
    return !pel_rect_empty(&o->seen) &&
           pel_smooth_begin(&o->smooth, surface, paint);
}

/* Where the circle is at the top of a row; between the corners of a rectangle
 * as far away as it can be. */
static int32_t bow_at(const struct pel_smooth_outline *o,
                      const struct pel_smooth_bow *b, int32_t y)
{
    const int32_t above = b->center.y - y * 256;
    const int32_t distance = pel_max(above, -above - o->spread.y);
    return distance > 0 ? pel_smooth_arc_at(&b->circle, distance, false)
                        : b->circle.reach;
}

static void go_to(const struct pel_smooth_outline *o, struct pel_smooth_bow *b,
                  int32_t y)
{
    if (b->row == y)
        return;
    b->at[0] = b->row == y - 1 ? b->at[1] : bow_at(o, b, y);
    b->at[1] = bow_at(o, b, y + 1);
    b->row = y;
}

/* What the upper half of a circle, or the lower one, has in a row, whose top is
 * so far below its upper centres. Places a unit outside of the circle do not
 * matter. */
static PEL_NOINLINE_32 void visit_half(const struct pel_smooth_outline *o,
                                       const struct pel_smooth_bow *b,
                                       int32_t down, bool below,
                                       struct pel_smooth_visitor *visitor)
{
    struct pel_smooth_crossing c;
    struct pel_smooth_strip *const s = &c.strip;
    const int32_t near = below ? down - o->spread.y : -256 - down;
    const int32_t far = pel_min(near + 256, b->circle.radius);
    if (near >= far || far <= 0)
        return;
    s->circle = &b->circle;
    c.below = below;
    c.other = -1;
    for (int32_t k = 0; k < b->count; k++) {
        const int32_t quadrant = (b->first + k) & 3;
        if ((quadrant < 2) != below)
            continue;
        s->near = pel_max(near, 0) * 256;
        s->far = far * 256;
        s->at_near = near > 0 ? b->at[!below] : b->circle.reach;
        s->at_far = pel_min(b->at[below], s->at_near);
        if (o->cut && !o->cut(s, b, k, quadrant & 1))
            continue;
        c.left = quadrant == 1 || quadrant == 2;
        c.rising = c.left != b->hole;
        c.center = c.left ? -b->center.x : b->center.x + o->spread.x;
        visitor->visit(visitor, &c);
    }
}

/* Apart from the others, for less stack. */
static PEL_NOINLINE void visit_others(struct pel_smooth_outline *o, int32_t y,
                                      struct pel_smooth_visitor *visitor)
{
    struct pel_smooth_crossing c;
    for (int32_t i = 0; i < o->others; i++) {
        c.other = (int8_t)i;
        if (o->other(o, y, i, &c))
            visitor->visit(visitor, &c);
    }
}

void pel_smooth_visit(struct pel_smooth_outline *o, int32_t y,
                      struct pel_smooth_visitor *visitor)
{
    for (struct pel_smooth_bow *b = o->bow; b < o->bow + o->bows; b++) {
        const int32_t down = y * 256 - b->center.y;
        if (down <= -b->circle.radius - 256 ||
            down >= b->circle.radius + o->spread.y)
            continue;
        go_to(o, b, y);
        visit_half(o, b, down, false, visitor);
        visit_half(o, b, down, true, visitor);
    }
    visit_others(o, y, visitor);
}

/* Some columns of a row, in which the areas right of its sides are added up. */
struct window {
    struct pel_smooth_visitor visitor; /* first */
    int32_t y, x, n;                   /* columns from x on */
    int32_t used; /* of them, up to the last one that a side crosses */
    int32_t next; /* the first one behind it that a side crosses */
    union {
        int32_t sum[COLUMNS + 1]; /* what each has more than the one before it,
                                     and what those up to `next` have, 2^-15 px
                                   */
        uint8_t coverage[COLUMNS];
    } of;
};

/* Adds what lies right of a side in columns, which it crosses, and behind them;
 * or takes it away. */
static void add_columns(struct window *w, struct pel_smooth_crossing *c,
                        struct pel_span columns)
{
    struct pel_smooth_arc_piece piece = {0, 0, INT32_MIN, 0};
    const int32_t h = pel_smooth_height(&c->strip);
    int32_t *sum = w->of.sum + (columns.x1 - w->x);
    int32_t n = columns.x1 - columns.x0, x = c->left ? -columns.x1 : columns.x0;
    *sum += c->rising ? h : -h;
    sum -= c->left ? 1 : n;
    pel_smooth_strip_set(&c->strip);
    for (; n > 0; n--, x++, sum += c->left ? -1 : 1) {
        const int32_t u = pel_smooth_boundary(c, x);
        int32_t area = (int32_t)pel_smooth_column_area(&c->strip, u, &piece);
        if (!c->left)
            area = h - area;
        if (!c->rising)
            area = -area;
        sum[0] += area;
        sum[1] -= area;
    }
}

static void add_side(struct pel_smooth_visitor *window,
                     struct pel_smooth_crossing *c)
{
    struct window *const w = (void *)window;
    const int32_t h = pel_smooth_height(&c->strip), end = w->x + w->n;
    struct pel_span columns = pel_smooth_crossing_columns(c);
    if (columns.x1 <= w->x)
        w->of.sum[0] += c->rising ? h : -h;
    if (columns.x1 > end)
        w->next = pel_min(w->next, pel_max(columns.x0, end));
    columns.x0 = pel_max(columns.x0, w->x);
    columns.x1 = pel_min(columns.x1, end);
    if (columns.x0 >= columns.x1)
        return;
    w->used = pel_max(w->used, columns.x1 - w->x);
    add_columns(w, c, columns);
}

static PEL_NOINLINE void fill_window(struct pel_smooth_outline *o,
                                     struct window *w)
{
    w->n = pel_min(o->seen.x1 - w->x, COLUMNS);
    w->next = o->seen.x1;
    w->used = 0;
    /* volatile: no call of memset, which may be the only one */
    for (int32_t i = 0; i <= w->n; i++)
        ((volatile int32_t *)w->of.sum)[i] = 0;
    pel_smooth_visit(o, w->y, &w->visitor);
}

/* Where ends meet a sum may be more than a pixel. */
static uint8_t coverage_of(int32_t sum)
{
    return pel_smooth_coverage((uint32_t)pel_min(sum, 32768));
}

/* Sums become bytes, each after the sum that it lies in has been read. All
 * pixels from `used` to `next` are full or empty, or the window is as long as
 * it can be. How many are full. */
static PEL_NOINLINE int32_t find_coverage(struct window *w)
{
    int32_t sum = 0;
    for (int32_t i = 0;; i++) {
        sum += w->of.sum[i];
        const uint8_t coverage = coverage_of(sum);
        if (i >= w->used) {
            w->used = i;
            if (coverage == 255)
                return w->next - w->x - i;
            if (coverage == 0)
                return 0;
            if (i == w->n) {
                w->next = w->x + i;
                return 0;
            }
        }
        w->of.coverage[i] = coverage;
    }
}

static void paint_row(struct pel_smooth_outline *o, int32_t y)
{
    struct window w;
    w.visitor.visit = add_side;
    w.y = y;
    for (w.x = o->seen.x0; w.x < o->seen.x1; w.x = w.next) {
        fill_window(o, &w);
        const int32_t full = find_coverage(&w);
        const struct pel_smooth_row row = {y,    w.x, w.used,
                                           full, 0,   w.of.coverage};
        pel_smooth_paint(&o->smooth, &row);
    }
}

void pel_smooth_outline_paint(struct pel_smooth_outline *o)
{
    const bool twins = !PEL_SMOOTH_TINY && o->twins;
    const int32_t end = twins ? (o->image_y >> 1) + 1 : o->seen.y1;
    for (int32_t y = o->seen.y0, n; y < end; y += n) {
        n = PEL_SMOOTH_TINY ? 0 : pel_smooth_whole_rows(o, y, end);
        if (n > 0)
            continue;
        paint_row(o, y);
        if (twins && o->image_y > 2 * y)
            paint_row(o, o->image_y - y);
        n = 1;
    }
}
