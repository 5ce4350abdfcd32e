#include "outline.h"

/* Numbers of quarters that a bow has, of which it may have 5. */
enum { BOW = 8 };

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
    o->inside = box->x0 >= clip->x0 && box->x1 <= clip->x1;
    o->twins = o->twins && box->y0 >= clip->y0 && box->y1 <= clip->y1;
    o->image_y = box->y0 + box->y1 - 1;
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
                        : pel_smooth_reach(&b->circle);
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

/* A quarter's piece is cut at an end: where it begins, near the axis, or where
 * it ends. */
static void cut_at(struct pel_smooth_strip *s, const struct pel_smooth_place *p,
                   bool begins)
{
    const int32_t v = pel_magnitude(p->y), u = pel_magnitude(p->x);
    if (begins && v > s->near) {
        s->near = v;
        s->at_near = u;
    }
    if (!begins && v < s->far) {
        s->far = v;
        s->at_far = u;
    }
}

/* The kth quarter's, whose places a unit outside of the circle do not matter.
 */
static bool find_quarter(const struct pel_smooth_outline *o,
                         const struct pel_smooth_bow *b, int32_t y, int32_t k,
                         struct pel_smooth_strip *s)
{
    const int32_t quadrant = (b->first + k) & 3, below = quadrant < 2;
    const int32_t down = y * 256 - b->center.y;
    const int32_t near = below ? down - o->spread.y : -256 - down;
    const int32_t far = pel_min(near + 256, b->circle.radius);
    if (k >= b->count || near >= far || far <= 0)
        return false;
    s->circle = &b->circle;
    s->near = pel_max(near, 0) * 256;
    s->far = far * 256;
    s->at_near = near > 0 ? b->at[!below] : pel_smooth_reach(&b->circle);
    s->at_far = b->at[below];
    if (!b->whole && k == 0)
        cut_at(s, &b->from, quadrant % 2 == 0);
    if (!b->whole && k == b->count - 1)
        cut_at(s, &b->to, quadrant % 2 == 1);
    s->at_far = pel_min(s->at_far, s->at_near);
    return s->near < s->far;
}

static bool find_of_bow(const struct pel_smooth_outline *o,
                        struct pel_smooth_bow *b, int32_t y, int32_t k,
                        struct pel_smooth_crossing *c)
{
    const int32_t quadrant = (b->first + k) & 3;
    c->left = quadrant == 1 || quadrant == 2;
    c->rising = c->left != b->hole;
    c->center = c->left ? -b->center.x : b->center.x + o->spread.x;
    go_to(o, b, y);
    return find_quarter(o, b, y, k, &c->strip);
}

int32_t pel_smooth_crossings(const struct pel_smooth_outline *o)
{
    return BOW * o->bows + o->others;
}

bool pel_smooth_crossing_find(struct pel_smooth_outline *o, int32_t y,
                              int32_t i, struct pel_smooth_crossing *c)
{
    if (i < BOW * o->bows)
        return find_of_bow(o, &o->bow[i / BOW], y, i % BOW, c);
    return o->other(o, y, i - BOW * o->bows, c);
}

/* Some columns of a row, in which the areas right of its sides are added up. */
struct window {
    int32_t y, x, n; /* columns from x on */
    int32_t used;    /* of them, up to the last one that a side crosses */
    int32_t next;    /* the first one behind it that a side crosses */
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
        const int32_t u = (x * 256 - c->center) * 256;
        int32_t area = (int32_t)pel_smooth_column_area(&c->strip, u, &piece);
        if (!c->left)
            area = h - area;
        if (!c->rising)
            area = -area;
        sum[0] += area;
        sum[1] -= area;
    }
}

static void add_side(struct window *w, struct pel_smooth_crossing *c)
{
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
    const int32_t count = pel_smooth_crossings(o);
    w->n = pel_min(o->seen.x1 - w->x, COLUMNS);
    w->next = o->seen.x1;
    w->used = 0;
    for (int32_t i = 0; i <= w->n; i++)
        w->of.sum[i] = 0;
    for (int32_t i = 0; i < count; i++) {
        struct pel_smooth_crossing c;
        if (pel_smooth_crossing_find(o, w->y, i, &c))
            add_side(w, &c);
    }
}

/* Where ends meet a sum may be more than a pixel. */
static uint8_t coverage_of(int32_t sum)
{
    return pel_smooth_coverage((uint32_t)pel_min(sum, 32768));
}

/* Sums become bytes, each after the sum that it lies in has been read. All
 * pixels up to `next` are full or empty, or the window is as long as it can be.
 * How many are full. */
static PEL_NOINLINE int32_t find_coverage(struct window *w)
{
    int32_t sum = 0, i = 0;
    for (; i < w->used; i++) {
        sum += w->of.sum[i];
        w->of.coverage[i] = coverage_of(sum);
    }
    const uint8_t even = coverage_of(sum + w->of.sum[i]);
    if (even == 255)
        return w->next - w->x - i;
    if (even > 0) {
        for (; i < w->n; i++)
            w->of.coverage[i] = even;
        w->used = i;
        w->next = w->x + i;
    }
    return 0;
}

static void paint_row(struct pel_smooth_outline *o, int32_t y)
{
    struct window w;
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
