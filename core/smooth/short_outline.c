#include "short_outline.h"

#if PEL_SMOOTH_TINY
#include "outline_row.h"

/* Curves whose places are kept from row to row: the first two. */
enum { KEPT = PEL_SMALL_CODE ? 0 : 2 };

/* Where they are at the next row. */
static void move_down(struct pel_smooth_short_outline *t)
{
    for (int32_t i = 0; i < KEPT; i++) {
        t->at[i][0] = t->at[i][1];
        t->at[i][1] = -1;
    }
}

bool pel_smooth_short_outline_begin(struct pel_smooth_short_outline *t,
                                    const struct pel_rect *box)
{
    const struct pel_rect r = pel_rect_intersect(box, &t->smooth.target->clip);
    t->seen.x = (int16_t)r.x0;
    t->seen.y = (int16_t)r.y0;
    t->seen.last_x = (int16_t)(r.x1 - 1);
    t->seen.last_y = (int16_t)(r.y1 - 1);
    t->part.full = (struct pel_span){r.x0, r.x0};
    t->part.some = t->part.full;
    for (int32_t i = 0; i < KEPT; i++)
        t->at[i][1] = -1;
    move_down(t);
    return !pel_rect_empty(&r) &&
           pel_smooth_begin(&t->smooth, t->smooth.target, t->smooth.paint);
}

/* Sets the ith curve, and where it is if that is kept: how many quarters it
 * has, if some may be in the row. */
static PEL_NOINLINE int32_t set_curve(struct pel_smooth_short_outline *t,
                                      const struct pel_smooth_kind *kind,
                                      int32_t i)
{
    const struct pel_smooth_curve *const c = &t->of.window.curve;
    int32_t *const at = t->at[i < KEPT ? i : 0];
    const int32_t y = t->seen.y;
    if (!kind->curve(t, i, &t->of.window.curve) || !pel_smooth_curve_in(c, y))
        return 0;
    for (int32_t k = 0; k < 2; k++)
        if (PEL_SMALL_CODE || (i < KEPT && at[k] < 0))
            at[k] = pel_smooth_curve_at(c, y + k);
    return c->circle.count;
}

/* Finds what its kth quarter has in the row; false: nothing. */
static PEL_NOINLINE bool find_quarter(struct pel_smooth_short_outline *t,
                                      const struct pel_smooth_kind *kind,
                                      int32_t i, int32_t k)
{
    struct pel_smooth_window *const w = &t->of.window;
    const int32_t y = t->seen.y;
    if (!pel_smooth_find_quarter(&w->curve, y, k, &w->crossing))
        return false;
    if (PEL_SMALL_CODE || i < KEPT) {
        pel_smooth_place_quarter(&w->crossing, t->at[i < KEPT ? i : 0]);
    } else {
        const int32_t at[2] = {pel_smooth_curve_at(&w->curve, y),
                               pel_smooth_curve_at(&w->curve, y + 1)};
        pel_smooth_place_quarter(&w->crossing, at);
    }
    return !kind->cut || kind->cut(t, i, k);
}

static void add_side(struct pel_smooth_short_outline *t);

/* Adds all sides of the row. They are found in functions that have returned
 * when they are added. */
static PEL_ALWAYS_INLINE void add_sides(struct pel_smooth_short_outline *t,
                                        const struct pel_smooth_kind *kind)
{
    for (int32_t i = 0; i < kind->curves; i++)
        for (int32_t k = set_curve(t, kind, i); --k >= 0;)
            if (find_quarter(t, kind, i, k))
                add_side(t);
    for (int32_t i = 0; i < kind->others; i++)
        if (kind->other(t, i, &t->of.window.crossing))
            add_side(t);
}

#if PEL_SMALL_CODE
/* Adds what lies right of a side in the pixel, or takes it away. */
static PEL_NOINLINE void add_side(struct pel_smooth_short_outline *t)
{
    const struct pel_smooth_crossing *const c = &t->of.window.crossing;
    const struct pel_span columns = pel_smooth_crossing_columns(c);
    const int32_t x = t->part.full.x1;
    int32_t area = pel_smooth_height(&c->strip);
    if (x < columns.x1)
        t->part.some.x1 = pel_min(t->part.some.x1, pel_max(columns.x0, x + 1));
    if (x < columns.x0)
        return;
    if (x < columns.x1) {
        const int32_t u = pel_smooth_boundary(c, c->left ? ~x : x);
        struct pel_smooth_arc_piece piece = {0, 0, INT32_MIN, 0};
        const int32_t part =
            (int32_t)pel_smooth_column_area(&c->strip, u, &piece);
        area = c->left ? part : area - part;
    }
    t->of.window.sum[0] += c->rising ? area : -area;
}

/* The pixels of a row, up to full or empty ones, or as many as there is room
 * for. */
static PEL_ALWAYS_INLINE void find_part(struct pel_smooth_short_outline *t,
                                        const struct pel_smooth_kind *kind)
{
    struct pel_smooth_part *const p = &t->part;
    p->some.x0 = p->full.x1;
    for (; p->full.x1 <= t->seen.last_x &&
           p->full.x1 < p->some.x0 + PEL_SMOOTH_COLUMNS;
         p->full.x1++) {
        t->part.some.x1 = t->seen.last_x + 1;
        t->of.window.sum[0] = 0;
        add_sides(t, kind);
        const uint8_t coverage = pel_smooth_sum_coverage(t->of.window.sum[0]);
        p->coverage[p->full.x1 - p->some.x0] = coverage;
        if (pel_smooth_is_whole(coverage)) {
            const int32_t next = p->some.x1;
            p->some.x1 = p->full.x1;
            p->full.x0 = coverage ? p->full.x1 : next;
            p->full.x1 = next;
            return;
        }
    }
    p->some.x1 = p->full.x0 = p->full.x1;
}
#else
/* Adds what lies right of the side in its columns, and behind them; or takes it
 * away. Until a part is found its some.x0 is the next column behind the window
 * that a side crosses, and some.x1 the number of those up to the last one in it
 * that a side crosses. */
static PEL_NOINLINE void add_side(struct pel_smooth_short_outline *t)
{
    const struct pel_smooth_crossing *const c = &t->of.window.crossing;
    const int32_t x = t->part.full.x1;
    const int32_t end = pel_min(x + PEL_SMOOTH_COLUMNS, t->seen.last_x + 1);
    struct pel_span columns = pel_smooth_crossing_columns(c);
    int32_t height = pel_smooth_height(&c->strip);
    if (!c->rising)
        height = -height;
    if (columns.x1 <= x)
        t->of.window.sum[0] += height;
    if (columns.x1 > end)
        t->part.some.x0 = pel_min(t->part.some.x0, pel_max(columns.x0, end));
    columns.x0 = pel_max(columns.x0, x);
    columns.x1 = pel_min(columns.x1, end);
    if (columns.x0 >= columns.x1)
        return;
    t->part.some.x1 = pel_max(t->part.some.x1, columns.x1 - x);
    pel_smooth_add_columns(c, columns, height,
                           t->of.window.sum + (columns.x1 - x));
}

static PEL_ALWAYS_INLINE void fill_window(struct pel_smooth_short_outline *t,
                                          const struct pel_smooth_kind *kind)
{
    t->part.some = (struct pel_span){t->seen.last_x + 1, 0};
    /* volatile: no call of memset, which may be the only one */
    for (int32_t i = 0; i <= PEL_SMOOTH_COLUMNS; i++)
        ((volatile int32_t *)t->of.window.sum)[i] = 0;
    add_sides(t, kind);
}

/* The pixels of a window from the first to the last that is covered, or those
 * of them that sides cross, and the full ones behind them. All of these up to
 * the next column that a side crosses are alike, or the window is as long as it
 * can be. */
static PEL_NOINLINE void read_window(struct pel_smooth_short_outline *t)
{
    struct pel_smooth_part *const p = &t->part;
    const int32_t x = p->full.x1, next = p->some.x0;
    const int32_t most = pel_min(t->seen.last_x + 1 - x, PEL_SMOOTH_COLUMNS);
    int32_t sum = 0, i = 0, first = 0, some = 0;
    for (;; i++) {
        sum += t->of.window.sum[i];
        const uint8_t coverage = pel_smooth_sum_coverage(sum);
        if (i >= p->some.x1 && (i == most || pel_smooth_is_whole(coverage))) {
            p->full.x1 = pel_smooth_is_whole(coverage) ? next : x + i;
            p->full.x0 = coverage == 255 ? x + i : p->full.x1;
            p->some = (struct pel_span){x + first, x + some};
            return;
        }
        if (coverage)
            some = i + 1;
        if (some)
            p->coverage[i - first] = coverage;
        else
            first = i + 1;
    }
}

static PEL_ALWAYS_INLINE void find_part(struct pel_smooth_short_outline *t,
                                        const struct pel_smooth_kind *kind)
{
    fill_window(t, kind);
    read_window(t);
}
#endif

bool pel_smooth_next_part(struct pel_smooth_short_outline *t,
                          const struct pel_smooth_kind *kind)
{
    if (t->part.some.x0 < t->part.some.x1)
        pel_smooth_drawing_end(&t->of.drawing, t->part.coverage);
    if (t->part.full.x1 > t->seen.last_x) {
        if (t->seen.y == t->seen.last_y)
            return false;
        t->part.full.x1 = t->seen.x;
        t->seen.y++;
        move_down(t);
    }
    find_part(t, kind);
    return true;
}

bool pel_smooth_begin_part(struct pel_smooth_short_outline *t,
                           const struct pel_span *span)
{
    struct pel_smooth_drawing *const d = &t->of.drawing;
    if (span->x0 >= span->x1)
        return false;
    pel_smooth_drawing_set(d, &t->smooth, t->seen.y, span);
    return span == &t->part.full || pel_smooth_drawing_begin(d, &t->smooth);
}
#endif
