/* Rows of outlines, painted some columns at a time: the areas right of the
 * sides that cross them are added up, in any order. */
#include "outline.h"

#if !PEL_SMOOTH_TINY

/* Columns whose areas are summed at a time. */
enum { COLUMNS = 16, CROSSINGS = 8 };

/* Some pixels of a row with a coverage each, and full ones behind them. */
struct part {
    int32_t y;
    struct pel_span some, full;
    uint8_t coverage[COLUMNS];
};

/* Some columns of a row, in which the areas right of its sides are added up. */
struct window {
    int32_t x, n;       /* columns from x on */
    int32_t used;       /* of them, up to the last one that a side crosses */
    int32_t next;       /* the first one behind them that a side crosses */
    int32_t first, all; /* the first crossing, and how many there are */
    int32_t sum[COLUMNS + 1]; /* what each has more than the one before it, and
                                 what those up to `next` have, 2^-15 px */
    struct pel_smooth_crossing at[CROSSINGS];
};

/* Adds what lies right of a side. */
static inline void add_side(struct window *w,
                            const struct pel_smooth_crossing *c)
{
    const int32_t h = pel_smooth_height(&c->strip), height = c->rising ? h : -h;
    const int32_t x = w->x, end = x + w->n;
    struct pel_span columns = pel_smooth_crossing_columns(c);
    if (columns.x1 <= x) {
        w->sum[0] += height;
        return;
    }
    if (columns.x1 > end)
        w->next = pel_min(w->next, pel_max(columns.x0, end));
    columns.x0 = pel_max(columns.x0, x);
    columns.x1 = pel_min(columns.x1, end);
    if (columns.x0 >= columns.x1)
        return;
    w->used = pel_max(w->used, columns.x1 - x);
    pel_smooth_add_columns(c, columns, height, w->sum + (columns.x1 - x));
}

static void clear_window(struct pel_smooth_outline *o, int32_t x,
                         struct window *w)
{
    w->x = x;
    w->n = pel_min(o->seen.x1 - x, COLUMNS);
    w->next = o->seen.x1;
    w->used = 0;
    /* volatile: no call of memset, which may be the only one */
    for (int32_t i = w->n; i >= 0; i--)
        ((volatile int32_t *)w->sum)[i] = 0;
}

static void fill_window(struct pel_smooth_outline *o, int32_t x, int32_t y,
                        struct window *w)
{
    int32_t first = 0;
    clear_window(o, x, w);
    do {
        if (first != w->first)
            w->all = pel_smooth_find_crossings(o, y, first, CROSSINGS, w->at);
        w->first = first;
        const int32_t n = pel_min(w->all - first, CROSSINGS);
        for (int32_t i = 0; i < n; i++)
            add_side(w, &w->at[i]);
        first += CROSSINGS;
    } while (first < w->all);
}

/* The pixels of a window from the first to the last that is covered, or those
 * of them that sides cross, and the full ones behind them: where the next ones
 * begin. All of these up to `next` are alike, or the window is as long as it
 * can be. */
static inline int32_t read_window(const struct window *w, struct part *p)
{
    int32_t sum = 0, i = 0, first = 0, some = 0;
    for (;; i++) {
        sum += w->sum[i];
        const uint8_t coverage = pel_smooth_sum_coverage(sum);
        if (i >= w->used && (i == w->n || pel_smooth_is_whole(coverage))) {
            const int32_t end = w->x + i;
            p->some = (struct pel_span){w->x + first, w->x + some};
            p->full = (struct pel_span){end, coverage == 255 ? w->next : end};
            return pel_smooth_is_whole(coverage) ? w->next : end;
        }
        if (coverage)
            some = i + 1;
        if (some)
            p->coverage[i - first] = coverage;
        else
            first = i + 1;
    }
}

/* Paints a row, and its mirror image. */
static PEL_NOINLINE_32 void paint_row(struct pel_smooth_outline *o, int32_t y)
{
    struct window w;
    struct part p;
    p.y = y;
    w.first = -1;
    for (int32_t x = o->seen.x0; x < o->seen.x1;) {
        fill_window(o, x, y, &w);
        x = read_window(&w, &p);
        const int32_t n = p.full.x0 - p.some.x0;
        struct pel_smooth_row row = {y, p.some.x0, n, p.full.x1 - p.full.x0,
                                     0, p.coverage};
        pel_smooth_paint(&o->smooth, &row);
        row.y = o->mirror_y - y;
        if (o->mirrored && row.y > y)
            pel_smooth_paint(&o->smooth, &row);
    }
}

static void paint_rows(struct pel_smooth_outline *o, int32_t y, int32_t end)
{
    for (int32_t n; y < end; y += n) {
        n = pel_smooth_whole_rows(o, y, end);
        if (n > 0)
            continue;
        paint_row(o, y);
        n = 1;
    }
}

void pel_smooth_outline_paint(struct pel_smooth_outline *o)
{
    const int32_t from = pel_min(o->mirror_from, o->seen.y1);
    paint_rows(o, o->seen.y0, from);
    if (from == o->seen.y1)
        return;
    o->mirrored = true;
    paint_rows(o, from, (o->mirror_y >> 1) + 1);
    o->mirrored = false;
    paint_rows(o, o->mirror_y - from + 1, o->seen.y1);
}
#endif
