#include "outline.h"

/* Columns whose areas are summed at a time. */
enum { COLUMNS = PEL_SMOOTH_TINY ? 8 : 16 };

void pel_smooth_curve_set(struct pel_smooth_curve *curve, int32_t radius)
{
    pel_smooth_circle_set(&curve->circle, radius);
    curve->row = INT32_MAX;
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
        o->mirrored &= box->y0 >= clip->y0 && box->y1 <= clip->y1;
        o->mirror_y = box->y0 + box->y1 - 1;
        o->alike = INT32_MIN;
    }
    return !pel_rect_empty(&o->seen) &&
           pel_smooth_begin(&o->smooth, surface, paint);
}

/* Where the circle is at the top of a row; between the corners of a rectangle
 * as far away as it can be. */
static int32_t curve_at(const struct pel_smooth_outline *o,
                        const struct pel_smooth_curve *curve, int32_t y)
{
    const int32_t above = curve->center.y - y * 256;
    const int32_t distance = pel_max(above, -above - o->spread.y);
    return distance > 0 ? pel_smooth_arc_at(&curve->circle, distance, false)
                        : curve->circle.reach;
}

static void go_to(const struct pel_smooth_outline *o,
                  struct pel_smooth_curve *curve, int32_t y)
{
    if (curve->row == y)
        return;
    curve->at[0] = curve->row == y - 1 ? curve->at[1] : curve_at(o, curve, y);
    curve->at[1] = curve_at(o, curve, y + 1);
    curve->row = y;
}

/* What the kth quarter of a circle has in a row, whose top is so far below its
 * upper centres: false where it has nothing. Places a unit outside of the
 * circle do not matter. */
static inline bool find_quarter(const struct pel_smooth_outline *o,
                                const struct pel_smooth_curve *curve,
                                int32_t down, int32_t k,
                                struct pel_smooth_crossing *c)
{
    struct pel_smooth_strip *const s = &c->strip;
    const int32_t quadrant = (curve->first + k) & 3;
    const bool below = quadrant < 2;
    const int32_t near = below ? down - o->spread.y : -256 - down;
    const int32_t far = pel_min(near + 256, curve->circle.radius);
    if (near >= far || far <= 0)
        return false;
    s->circle = &curve->circle;
    s->near = pel_max(near, 0) * 256;
    s->far = far * 256;
    s->at_near = near > 0 ? curve->at[!below] : curve->circle.reach;
    s->at_far = pel_min(curve->at[below], s->at_near);
    c->below = below;
    c->other = -1;
    c->left = quadrant == 1 || quadrant == 2;
    c->rising = c->left != curve->hole;
    c->center = c->left ? -curve->center.x : curve->center.x + o->spread.x;
    return !o->cut || o->cut(s, curve, k, quadrant & 1);
}

static inline void visit_curve(const struct pel_smooth_outline *o,
                               const struct pel_smooth_curve *curve,
                               int32_t down, struct pel_smooth_visitor *visitor)
{
    struct pel_smooth_crossing c;
    for (int32_t k = 0; k < curve->count; k++)
        if (find_quarter(o, curve, down, k, &c))
            visitor->visit(visitor, &c);
}

bool pel_smooth_upright(struct pel_smooth_crossing *c, int32_t y, int64_t from,
                        int64_t to)
{
    const int64_t top = (int64_t)y * 65536;
    from = from > top ? from - top : 0;
    to = to - top < 65536 ? to - top : 65536;
    c->strip.circle = NULL;
    c->strip.near = 0;
    c->strip.far = (int32_t)(to - from);
    return from < to;
}

void pel_smooth_others(struct pel_smooth_outline *o, int32_t y,
                       struct pel_smooth_visitor *visitor)
{
    struct pel_smooth_crossing c;
    for (int32_t i = 0; i < o->count; i++) {
        c.other = (int8_t)i;
        if (o->other(o, y, i, &c))
            visitor->visit(visitor, &c);
    }
}

void pel_smooth_visit_curves(struct pel_smooth_outline *o, int32_t y,
                             struct pel_smooth_visitor *visitor)
{
    for (struct pel_smooth_curve *curve = o->curve;
         curve < o->curve + o->curves; curve++) {
        const int32_t down = y * 256 - curve->center.y;
        if (down <= -curve->circle.radius - 256 ||
            down >= curve->circle.radius + o->spread.y)
            continue;
        go_to(o, curve, y);
        visit_curve(o, curve, down, visitor);
    }
}

/* Where ends meet a sum may be more than a pixel. */
static uint8_t coverage_of(int32_t sum)
{
    return pel_smooth_coverage((uint32_t)pel_min(sum, 32768));
}

/* Is it of a full pixel, or of one that is empty? */
static bool is_whole(uint8_t coverage)
{
    return (uint8_t)(coverage + 1) < 2;
}

#if PEL_SMALL_CODE
/* A pixel, in which the areas right of the sides are added up. */
struct window {
    struct pel_smooth_visitor visitor; /* first */
    int32_t x;
    int32_t next; /* up to here all are like it */
    int32_t sum;  /* 2^-15 px */
};

/* Adds what lies right of a side, or takes it away. */
static void add_side(struct pel_smooth_visitor *window,
                     struct pel_smooth_crossing *c)
{
    struct window *const w = (void *)window;
    struct pel_smooth_arc_piece piece = {0, 0, INT32_MIN, 0};
    const struct pel_span columns = pel_smooth_crossing_columns(c);
    const int32_t x = w->x;
    int32_t area = pel_smooth_height(&c->strip);
    if (x < columns.x1)
        w->next = pel_min(w->next, pel_max(columns.x0, x + 1));
    if (x < columns.x0)
        return;
    if (x < columns.x1) {
        const int32_t u = pel_smooth_boundary(c, c->left ? ~x : x);
        const int32_t part =
            (int32_t)pel_smooth_column_area(&c->strip, u, &piece);
        area = c->left ? part : area - part;
    }
    w->sum += c->rising ? area : -area;
}

/* The pixels of a row, up to full or empty ones, or as many as there is room
 * for: where the next ones begin. */
static PEL_NOINLINE int32_t find_coverage(struct pel_smooth_outline *o,
                                          struct pel_smooth_row *row,
                                          uint8_t *to)
{
    struct window w;
    w.visitor.visit = add_side;
    row->left = row->full = 0;
    for (w.x = row->x; w.x < o->seen.x1 && row->left < COLUMNS; w.x++) {
        w.next = o->seen.x1;
        w.sum = 0;
        pel_smooth_visit(o, row->y, &w.visitor);
        to[row->left] = coverage_of(w.sum);
        if (is_whole(to[row->left])) {
            row->full = to[row->left] ? w.next - w.x : 0;
            return w.next;
        }
        row->left++;
    }
    return w.x;
}
#else
/* Some columns of a row, in which the areas right of its sides are added up. */
struct window {
    struct pel_smooth_visitor visitor; /* first */
    int32_t x, n;                      /* columns from x on */
    int32_t used; /* of them, up to the last one that a side crosses */
    int32_t next; /* the first one behind them that a side crosses */
    int32_t sum[COLUMNS + 1]; /* what each has more than the one before it, and
                                 what those up to `next` have, 2^-15 px */
};

/* Adds what lies right of a side in columns, which it crosses, and behind them;
 * or takes it away. */
static void add_columns(struct window *w, const struct pel_smooth_crossing *c,
                        struct pel_span columns)
{
    struct pel_smooth_arc_piece piece = {0, 0, INT32_MIN, 0};
    const int32_t h = pel_smooth_height(&c->strip);
    int32_t *sum = w->sum + (columns.x1 - w->x);
    int32_t n = columns.x1 - columns.x0, x = c->left ? -columns.x1 : columns.x0;
    *sum += c->rising ? h : -h;
    sum -= c->left ? 1 : n;
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
        w->sum[0] += c->rising ? h : -h;
    if (columns.x1 > end)
        w->next = pel_min(w->next, pel_max(columns.x0, end));
    columns.x0 = pel_max(columns.x0, w->x);
    columns.x1 = pel_min(columns.x1, end);
    if (columns.x0 >= columns.x1)
        return;
    w->used = pel_max(w->used, columns.x1 - w->x);
    add_columns(w, c, columns);
}

static void fill_window(struct pel_smooth_outline *o, int32_t y,
                        struct window *w)
{
    w->visitor.visit = add_side;
    w->n = pel_min(o->seen.x1 - w->x, COLUMNS);
    w->next = o->seen.x1;
    w->used = 0;
    /* volatile: no call of memset, which may be the only one */
    for (int32_t i = 0; i <= w->n; i++)
        ((volatile int32_t *)w->sum)[i] = 0;
    pel_smooth_visit(o, y, &w->visitor);
}

/* The pixels of a row that sides cross, and the full ones behind them: where
 * the next ones begin. All of these up to `next` are alike, or the window is as
 * long as it can be. */
static PEL_NOINLINE int32_t find_coverage(struct pel_smooth_outline *o,
                                          struct pel_smooth_row *row,
                                          uint8_t *to)
{
    struct window w;
    w.x = row->x;
    fill_window(o, row->y, &w);
    int32_t sum = 0, i = 0;
    for (;; i++) {
        sum += w.sum[i];
        const uint8_t coverage = coverage_of(sum);
        if (i >= w.used && (i == w.n || is_whole(coverage))) {
            row->left = i;
            row->full = coverage == 255 ? w.next - w.x - i : 0;
            return is_whole(coverage) ? w.next : w.x + i;
        }
        to[i] = coverage;
    }
}
#endif

static void paint_row(struct pel_smooth_outline *o, int32_t y)
{
    uint8_t coverage[COLUMNS];
    struct pel_smooth_row row;
    int32_t next;
    row.y = y;
    row.right = 0;
    row.coverage = coverage;
    for (row.x = o->seen.x0; row.x < o->seen.x1; row.x = next) {
        next = find_coverage(o, &row, coverage);
        pel_smooth_paint(&o->smooth, &row);
    }
}

void pel_smooth_outline_paint(struct pel_smooth_outline *o)
{
    const bool mirrored = !PEL_SMOOTH_TINY && o->mirrored;
    const int32_t end = mirrored ? (o->mirror_y >> 1) + 1 : o->seen.y1;
    for (int32_t y = o->seen.y0, n; y < end; y += n) {
        n = PEL_SMOOTH_TINY ? 0 : pel_smooth_whole_rows(o, y, end);
        if (n > 0)
            continue;
        paint_row(o, y);
        if (mirrored && o->mirror_y > 2 * y)
            paint_row(o, o->mirror_y - y);
        n = 1;
    }
}
