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
    t->seen.y = (int16_t)r.y0;
    t->seen.last_y = (int16_t)(r.y1 - 1);
    pel_smooth_set_columns(t, &r);
    t->part.full.x1 = t->part.some.x0 = t->part.some.x1 = pel_smooth_first_x(t);
    for (int32_t i = 0; i < KEPT; i++)
        t->at[i][1] = -1;
    move_down(t);
    pel_smooth_no_order(t, false);
    return !pel_rect_empty(&r) &&
           pel_smooth_begin(&t->smooth, t->smooth.target, t->smooth.paint);
}

/* Finds where the curve is that was set: how many quarters it has, if some may
 * be in the row. */
PEL_SMOOTH_PLACE int32_t place_curve(struct pel_smooth_short_outline *t,
                                     int32_t i)
{
    const struct pel_smooth_curve *const c = &t->of.window.curve;
    int32_t *const at = t->at[i < KEPT ? i : 0];
    const int32_t y = t->seen.y;
    if (!pel_smooth_curve_in(c, y))
        return 0;
    for (int32_t k = 0; k < 2; k++)
        if (PEL_SMALL_CODE || (i < KEPT && at[k] < 0))
            at[k] = pel_smooth_curve_at(c, y + k);
    return c->circle.count;
}

PEL_SMOOTH_SHARED int32_t
pel_smooth_set_curve(struct pel_smooth_short_outline *t,
                     const struct pel_smooth_kind *kind, int32_t i)
{
    if (!kind->curve(t, i, false, &t->of.window.curve))
        return 0;
    return place_curve(t, i);
}

/* The same, before it is cut. */
PEL_SMOOTH_PLACE bool place_quarter(struct pel_smooth_short_outline *t,
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
    return true;
}

PEL_SMOOTH_SHARED bool pel_smooth_set_quarter(
    struct pel_smooth_short_outline *t, const struct pel_smooth_kind *kind,
    int32_t i, int32_t k)
{
    if (!place_quarter(t, i, k))
        return false;
    return !kind->cut || kind->cut(t, i, k);
}

PEL_SMOOTH_ONCE bool pel_smooth_end_part(struct pel_smooth_short_outline *t)
{
    if (t->part.some.x0 < t->part.some.x1)
        pel_smooth_drawing_end(&t->of.drawing, t->part.coverage);
    if (t->part.full.x1 > pel_smooth_last_x(t)) {
        if (t->seen.y == t->seen.last_y)
            return false;
        t->part.full.x1 = pel_smooth_first_x(t);
        t->seen.y++;
        move_down(t);
    }
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

/* Adds all sides of the row. They are found in functions that have returned
 * when they are added. */
static PEL_ALWAYS_INLINE void add_sides(struct pel_smooth_short_outline *t,
                                        const struct pel_smooth_kind *kind)
{
    for (uint32_t list = kind->sides; list; list >>= 4) {
        const int32_t side = list & 15;
        if (side >= PEL_SMOOTH_OTHER) {
            if (kind->other(t, side - PEL_SMOOTH_OTHER, &t->of.window.crossing))
                add_side(t);
            continue;
        }
        for (int32_t k = pel_smooth_set_curve(t, kind, side >> 1); --k >= 0;)
            if (pel_smooth_set_quarter(t, kind, side >> 1, k))
                add_side(t);
    }
}

/* The pixels of a row, up to full or empty ones, or as many as there is room
 * for. */
static PEL_ALWAYS_INLINE void find_part(struct pel_smooth_short_outline *t,
                                        const struct pel_smooth_kind *kind)
{
    struct pel_smooth_part *const p = &t->part;
    p->some.x0 = p->full.x1;
    for (; p->full.x1 <= pel_smooth_last_x(t) &&
           p->full.x1 < p->some.x0 + PEL_SMOOTH_COLUMNS;
         p->full.x1++) {
        t->part.some.x1 = pel_smooth_last_x(t) + 1;
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

bool pel_smooth_next_part(struct pel_smooth_short_outline *t,
                          const struct pel_smooth_kind *kind)
{
    if (!pel_smooth_end_part(t))
        return false;
    find_part(t, kind);
    return true;
}
#endif

#endif
