/* The parts of rows. Most rows have the same sides as the one above, which
 * cross them from top to bottom, and none crosses another. The order of such
 * sides is found once; then each is looked at only where it is. */
#include "short_outline.h"

#if PEL_SMOOTH_TINY && !PEL_SMALL_CODE
/* REST: all columns of a row. */
enum { BITS = 4, REST = 15 };

/* Adds what lies right of the side in its columns of the window, and behind
 * them; or takes it away. */
static PEL_NOINLINE void add_side(struct pel_smooth_short_outline *t,
                                  int32_t columns)
{
    const struct pel_smooth_crossing *const c = &t->of.window.crossing;
    const int32_t x = t->part.full.x1, from = columns & 15, to = columns >> 4;
    const int32_t height = pel_smooth_height(&c->strip);
    pel_smooth_add_columns(c, (struct pel_span){x + from, x + to},
                           c->rising ? height : -height, t->of.window.sum + to);
}

/* The pixels of a window from the first to the last that is covered, or those
 * of them that sides cross, and the full ones behind them. All of these up to
 * the next column that a side crosses are alike, or the window is as long as it
 * can be. */
static PEL_NOINLINE void read_window(struct pel_smooth_short_outline *t)
{
    struct pel_smooth_part *const p = &t->part;
    const int32_t x = p->full.x1, next = p->some.x0;
    const int32_t most =
        pel_min(pel_smooth_last_x(t) + 1 - x, PEL_SMOOTH_COLUMNS);
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

/* Begins to look at sides: of the row to find their order, or of its next part.
 */
static PEL_NOINLINE void begin_sides(struct pel_smooth_short_outline *t)
{
    t->part.some = (struct pel_span){pel_smooth_last_x(t) + 1, 0};
    t->part.full.x0 = t->part.full.x1;
    pel_smooth_search_of(t)->side = pel_smooth_search_of(t)->quarters =
        pel_smooth_search_of(t)->quarter = 0;
    /* volatile: no call of memset, which may be the only one */
    for (int32_t i = 0; i <= PEL_SMOOTH_COLUMNS; i++)
        ((volatile int32_t *)t->of.window.sum)[i] = 0;
}

/* The first quarter that may have a side of a curve. */
static int32_t first_quarter(const struct pel_smooth_short_outline *t,
                             int32_t side)
{
    const struct pel_smooth_curve *const c = &t->of.window.curve;
    const int32_t left = ~side & 1;
    const bool below = t->seen.y * 256 >= c->center.y;
    return ((below ? left : 3 - left) - c->circle.first) & 3;
}

/* The nth side of a list, which has 8 at most. */
static int32_t side_at(uint32_t list, int32_t n)
{
    return n < 8 ? list >> BITS * (n & 7) & 15 : 0;
}

/* Are all sides of the shape looked at, and not those of an order? */
static bool sees_all(struct pel_smooth_short_outline *t)
{
    return pel_smooth_search_of(t)->seek || !pel_smooth_has_order(t);
}

/* The number of the next side, or of a curve that has more; 0: there is none.
 */
static PEL_NOINLINE int32_t next_side(struct pel_smooth_short_outline *t,
                                      const struct pel_smooth_kind *kind)
{
    struct pel_smooth_search *const s = pel_smooth_search_of(t);
    const uint32_t list =
        sees_all(t) ? kind->sides
                    : (uint32_t)t->rows.order >> BITS * t->rows.passed;
    if (s->quarter < s->quarters)
        return side_at(list, s->side - 1);
    s->quarters = 0;
    return side_at(list, s->side++);
}

/* Sets the curve of a side; then finds what its next quarter has in the row.
 * False: nothing yet. */
static PEL_NOINLINE bool find_quarter(struct pel_smooth_short_outline *t,
                                      const struct pel_smooth_kind *kind,
                                      int32_t side)
{
    struct pel_smooth_search *const s = pel_smooth_search_of(t);
    const int32_t i = (side - 1) >> 1, k = s->quarter;
    if (s->quarters == 0) {
        s->quarters = (uint8_t)pel_smooth_set_curve(t, kind, i);
        s->quarter = (uint8_t)(sees_all(t) ? 0 : first_quarter(t, side));
        return false;
    }
    s->quarter = (uint8_t)(k + (sees_all(t) ? 1 : 4));
    return pel_smooth_set_quarter(t, kind, i, k);
}

/* What is to be done with a side that was found: nothing, nor with those that
 * follow it; or it is to be added in some columns of the window: the first one
 * and 16 times the end. */
enum { STOP = -1, GO_ON = 0 };

/* The columns of the window that a side crosses. Until a part is found its
 * some.x0 is the next column behind the window that a side crosses, and some.x1
 * the number of those up to the last one in it that a side crosses. */
static int32_t use_columns(struct pel_smooth_short_outline *t,
                           const struct pel_span *columns, int32_t end)
{
    struct pel_smooth_part *const p = &t->part;
    const int32_t x = p->full.x1;
    const int32_t from = pel_max(columns->x0, x);
    const int32_t to = pel_min(columns->x1, end);
    if (columns->x1 > end)
        p->some.x0 = pel_min(p->some.x0, pel_max(columns->x0, end));
    if (from >= to)
        return GO_ON;
    p->some.x1 = pel_max(p->some.x1, to - x);
    return (from - x) | (to - x) << 4;
}

/* A side of an order. The window begins at the first one that is not left of
 * it. */
static void pass_in_order(struct pel_smooth_short_outline *t,
                          const struct pel_span *columns)
{
    struct pel_smooth_part *const p = &t->part;
    if (p->some.x1 == 0 && columns->x1 > p->full.x1) {
        p->full.x1 =
            pel_min(pel_max(p->full.x1, columns->x0), pel_smooth_last_x(t) + 1);
        if (t->of.window.crossing.rising)
            p->full.x0 = p->full.x1;
        else
            t->of.window.sum[0] = 32768;
    }
    pel_smooth_search_of(t)->quarters = 0;
}

static PEL_NOINLINE int32_t use_side(struct pel_smooth_short_outline *t,
                                     int32_t side)
{
    const struct pel_smooth_crossing *const c = &t->of.window.crossing;
    const struct pel_span columns = pel_smooth_crossing_columns(c);
    if (pel_smooth_search_of(t)->seek)
        return pel_smooth_put_in_order(t, side, columns.x0) ? GO_ON : STOP;
    const bool in_order = pel_smooth_has_order(t);
    if (in_order)
        pass_in_order(t, &columns);
    const int32_t x = t->part.full.x1, end = pel_min(x + PEL_SMOOTH_COLUMNS,
                                                     pel_smooth_last_x(t) + 1);
    if (in_order && columns.x0 >= end)
        return STOP;
    if (in_order && columns.x1 <= end) {
        t->rows.passed = (t->rows.passed + 1) & 15;
        pel_smooth_search_of(t)->side--;
    } else if (!in_order && columns.x1 <= x) {
        const int32_t height = pel_smooth_height(&c->strip);
        t->of.window.sum[0] += c->rising ? height : -height;
    }
    return use_columns(t, &columns, end);
}

/* The columns of the window that sides cross. */
static PEL_NOINLINE void read_columns(struct pel_smooth_short_outline *t)
{
    struct pel_smooth_part *const p = &t->part;
    int32_t sum = 0, first = 0, end = 0;
    if (p->some.x1 == 0 && p->full.x0 == p->full.x1) /* no side was left */
        p->full.x0 = p->full.x1 = pel_smooth_last_x(t) + 1;
    t->rows.columns = t->rows.order >> BITS * t->rows.passed
                          ? (unsigned)p->some.x1 & 15
                          : REST;
    for (int32_t i = 0; i < p->some.x1; i++) {
        sum += t->of.window.sum[i];
        const uint8_t coverage = pel_smooth_sum_coverage(sum);
        if (coverage)
            end = i + 1;
        if (end)
            p->coverage[i - first] = coverage;
        else
            first = i + 1;
    }
    p->some.x0 = p->full.x1 + first;
    p->some.x1 = p->full.x1 + end;
}

/* Ends to look at sides; false: now those of the next part are to be looked at.
 */
static PEL_NOINLINE bool end_sides(struct pel_smooth_short_outline *t)
{
    if (pel_smooth_search_of(t)->seek) {
        pel_smooth_end_order(t);
        begin_sides(t);
        return false;
    }
    if (pel_smooth_has_order(t))
        read_columns(t);
    else
        read_window(t);
    return true;
}

/* Ends a part; false at the end. */
static PEL_NOINLINE bool pass_part(struct pel_smooth_short_outline *t)
{
    t->part.full.x1 = t->rows.columns == REST
                          ? pel_smooth_last_x(t) + 1
                          : t->part.full.x1 + t->rows.columns;
    t->rows.columns = 0;
    return pel_smooth_end_part(t);
}

static PEL_NOINLINE void begin_part(struct pel_smooth_short_outline *t,
                                    const struct pel_smooth_kind *kind)
{
    pel_smooth_search_of(t)->seek = false;
    if (t->part.full.x1 == pel_smooth_first_x(t))
        pel_smooth_begin_row(t, kind);
    begin_sides(t);
}

/* Sides are found in functions that have returned when they are added. */
bool pel_smooth_next_part(struct pel_smooth_short_outline *t,
                          const struct pel_smooth_kind *kind)
{
    if (!pass_part(t))
        return false;
    begin_part(t, kind);
    for (;;) {
        const int32_t side = next_side(t, kind);
        if (side >= PEL_SMOOTH_OTHER ? !kind->other(t, side - PEL_SMOOTH_OTHER,
                                                    &t->of.window.crossing)
                                     : side > 0 && !find_quarter(t, kind, side))
            continue;
        const int32_t use = side ? use_side(t, side) : STOP;
        if (use > 0)
            add_side(t, use);
        else if (use < 0 && end_sides(t))
            return true;
    }
}
#endif
