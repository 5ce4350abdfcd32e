/* The rows of a sweep: which edges cross them, and their pixels. */
#include "smooth_sweep.h"

/* False: it touches no row, or has no height. Edges right of the clip are kept:
 * they cut rows where they end and where they cross others, and so areas left
 * of them are rounded as without a clip. */
static bool is_seen(const struct pel_smooth_sweep *w, const struct pel_point *a,
                    const struct pel_point *b)
{
    return a->y < b->y && b->y > PEL_PX(w->y0) && a->y < PEL_PX(w->y1);
}

/* x at a row's top, `below` sub-pixels below the edge's: above it by up to 255,
 * or further down by less than the edge is high, so products are below 2^57.
 * Both ways give floor(step below / 256). */
static PEL_NOINLINE_32 int64_t x_in(const struct pel_point *a, int64_t step,
                                    int32_t below)
{
    const int64_t at = pel_smooth_wide(a->x);
    if (below < 0)
        return at + (int64_t)pel_times((uint64_t)(step >> 8), below) +
               (((int32_t)(step & 255) * below) >> 8);
    return at + ((int64_t)pel_times((uint64_t)step, below) >> 8);
}

/* From a down to b. */
static void add_edge(struct pel_smooth_sweep *w, const struct pel_point *a,
                     const struct pel_point *b, int32_t winding)
{
    struct pel_smooth_edge *const e = &w->edge[w->count];
    const int32_t row = pel_max(pel_pixel_of(a->y), w->y0);
    e->step = pel_smooth_slope(a, b, &e->rise);
    e->at = x_in(a, e->step, PEL_PX(row) - a->y);
    e->top = a->y;
    e->bottom = b->y;
    e->winding = winding;
    w->order[w->count] = w->count;
    w->count++;
}

bool pel_smooth_sweep_add(struct pel_smooth_sweep *w, const struct pel_point *a,
                          const struct pel_point *b)
{
    const bool down = a->y < b->y;
    const struct pel_point *const top = down ? a : b;
    const struct pel_point *const bottom = down ? b : a;
    if (!is_seen(w, top, bottom))
        return true;
    if (w->count == w->room)
        return false;
    add_edge(w, top, bottom, down ? 1 : -1);
    return true;
}

/* What add_edge has set, one by one: small compilers copy structs by a call. */
static void keep(struct pel_smooth_edge *to, const struct pel_smooth_edge *e)
{
    to->at = e->at;
    to->step = e->step;
    to->rise.value = e->rise.value;
    to->rise.steep = e->rise.steep;
    to->top = e->top;
    to->bottom = e->bottom;
    to->winding = e->winding;
}

void pel_smooth_sweep_cut(struct pel_smooth_sweep *w, int32_t y1)
{
    int32_t kept = 0;
    for (int32_t i = 0; i < w->count; i++)
        if (w->edge[i].top < PEL_PX(y1))
            keep(&w->edge[kept++], &w->edge[i]);
    w->count = kept;
    w->y1 = y1;
}

/* How many are 0, from the first on. */
static int32_t zeros(const int32_t *sum, int32_t n)
{
    int32_t i = 0;
    while (n - i >= 4 && (sum[i] | sum[i + 1] | sum[i + 2] | sum[i + 3]) == 0)
        i += 4;
    while (i < n && sum[i] == 0)
        i++;
    return i;
}

/* What a sum says, which then is 0. */
static int32_t take_sum(int32_t *sum)
{
    const int32_t value = *sum;
    *sum = 0;
    return value;
}

static int32_t coverage_of(int32_t area)
{
    return pel_max(0, pel_min(area >> 22, 255));
}

/* Is there more of the row from x on? Where no right border lies inside the
 * clip it goes on to the clip's end. */
static inline bool has_more(const struct pel_smooth_sweep *w, int32_t x)
{
    return x < w->smooth.target->clip.x1 &&
           (x < w->end || coverage_of(w->area) > 0);
}

/* Where the sums behind pixel x end that are 0. */
static int32_t end_of_run(const struct pel_smooth_sweep *w, int32_t x)
{
    const struct pel_rect *const clip = &w->smooth.target->clip;
    const int32_t left = pel_min(w->end, clip->x1) - x - 1;
    return left < 0 ? clip->x1 : x + 1 + zeros(&w->sum[x - clip->x0 + 1], left);
}

/* Pixels from row.x on, up to the next empty ones or others behind full ones,
 * or as many as there is room for: where the next ones begin. */
static PEL_NOINLINE_32 int32_t find_pixels(struct pel_smooth_sweep *w)
{
    enum { PIXELS = PEL_SMOOTH_SWEEP_PIXELS };
    const int32_t x0 = w->smooth.target->clip.x0;
    struct pel_smooth_row *const row = &w->row;
    int32_t x = row->x;
    row->left = row->full = 0;
    while (has_more(w, x)) {
        w->area += take_sum(&w->sum[x - x0]);
        const int32_t coverage = coverage_of(w->area), end = end_of_run(w, x);
        if (coverage == 0)
            return end;
        if (coverage < 255 && (row->full > 0 || row->left == PIXELS))
            return x;
        if (coverage == 255)
            row->full += end - x;
        for (; coverage < 255 && x < end && row->left < PIXELS; x++)
            w->coverage[row->left++] = (uint8_t)coverage;
        x = coverage < 255 ? x : end;
    }
    return x;
}

#if PEL_SMOOTH_TINY
/* For little stack the paint is called from the frame of the row. */
static PEL_ALWAYS_INLINE void paint_pixels(struct pel_smooth_sweep *w)
{
    const int32_t x = w->row.x, full = x + w->row.left;
    w->span = (struct pel_span){x, full};
    if (w->row.left > 0)
        pel_smooth_draw(w->drawing, &w->smooth, w->row.y, &w->span,
                        w->coverage);
    w->span = (struct pel_span){full, full + w->row.full};
    pel_smooth_draw_full(w->drawing, &w->smooth, w->row.y, &w->span);
}
#else
static void paint_pixels(const struct pel_smooth_sweep *w)
{
    pel_smooth_paint(&w->smooth, &w->row);
}
#endif

static PEL_NOINLINE_32 void paint_row(struct pel_smooth_sweep *w)
{
    w->area = 1 << 21;
    w->row.x = w->lo;
    while (has_more(w, w->row.x)) {
        const int32_t next = find_pixels(w);
        paint_pixels(w);
        w->row.x = next;
    }
    w->sum[w->row.x - w->smooth.target->clip.x0] = 0;
}

/* Edges that begin above the row's end become active. */
static PEL_NOINLINE_32 void enter(struct pel_smooth_sweep *w, int32_t bottom)
{
    while (w->active < w->count && w->edge[w->order[w->active]].top < bottom)
        w->active++;
}

/* Moves on to the row below. Edges that end above it are dropped, the others
 * close up to those to come. */
static PEL_NOINLINE_32 void advance(struct pel_smooth_sweep *w, int32_t bottom)
{
    int32_t *const order = w->order;
    int32_t gone = w->active;
    for (int32_t i = gone; i-- > 0;) {
        struct pel_smooth_edge *const e = &w->edge[order[i]];
        e->at += e->step;
        if (e->bottom > bottom)
            order[--gone] = order[i];
    }
    w->order += gone;
    w->count -= gone;
    w->active -= gone;
}

static void sweep_row(struct pel_smooth_sweep *w)
{
    enter(w, PEL_PX(w->row.y) + 256);
    w->lo = INT32_MAX;
    w->end = INT32_MIN;
    pel_smooth_add_row(w);
    if (w->lo < w->end)
        paint_row(w);
    advance(w, PEL_PX(w->row.y) + 256);
}

/* The first row that is drawn and that it touches, from w->y0 on. */
static inline int32_t row_of(const struct pel_smooth_sweep *w, int32_t i)
{
    return pel_max(pel_pixel_of(w->edge[i].top) - w->y0, 0);
}

#if PEL_SMOOTH_TINY
/* By their top: Shell sort, with gaps of 2^k - 1. */
static PEL_NOINLINE_32 void sort(struct pel_smooth_sweep *w)
{
    int32_t *const order = w->order;
    int32_t gap = 1;
    for (int32_t i = 0; i < w->count; i++)
        order[i] = i;
    while (gap < w->count / 4)
        gap = 2 * gap + 1;
    for (; gap; gap /= 2)
        for (int32_t i = gap; i < w->count; i++) {
            const int32_t edge = order[i], top = w->edge[edge].top;
            int32_t k = i;
            for (; k >= gap && w->edge[order[k - gap]].top > top; k -= gap)
                order[k] = order[k - gap];
            order[k] = edge;
        }
}
#else
/* By their first row: edges are counted in ranges of 2^shift rows, no more than
 * there are edges, whose x0 are the counters; within a range they are inserted.
 */
static PEL_NOINLINE_32 void sort(struct pel_smooth_sweep *w)
{
    int32_t *const order = w->order;
    int32_t sum = 0, shift = 0;
    while ((w->y1 - w->y0 - 1) >> shift >= w->count)
        shift++;
    for (int32_t i = 0; i < w->count; i++)
        w->edge[i].x0 = 0;
    for (int32_t i = 0; i < w->count; i++)
        w->edge[row_of(w, i) >> shift].x0++;
    for (int32_t i = 0; i < w->count; i++) {
        sum += w->edge[i].x0;
        w->edge[i].x0 = sum;
    }
    for (int32_t i = w->count; i-- > 0;)
        order[--w->edge[row_of(w, i) >> shift].x0] = i;
    for (int32_t i = 1; shift && i < w->count; i++) {
        const int32_t edge = order[i], row = row_of(w, edge);
        int32_t k = i;
        for (; k > 0 && row_of(w, order[k - 1]) > row; k--)
            order[k] = order[k - 1];
        order[k] = edge;
    }
}
#endif

void pel_smooth_sweep_paint(struct pel_smooth_sweep *w)
{
    w->row.y = w->y1;
    if (w->count > 0) {
        sort(w);
        w->row.y = w->y0 + row_of(w, w->order[0]);
    }
    for (; w->row.y < w->y1 && w->count > 0; w->row.y++)
        sweep_row(w);
    w->count = w->active = 0;
    w->order = (int32_t *)(void *)(w->edge + w->room);
}

static void clear(int32_t *sum, const struct pel_rect *clip)
{
    for (int32_t x = clip->x0; x <= clip->x1; x++)
        *sum++ = 0;
}

void pel_smooth_sweep_begin(struct pel_smooth_sweep *w, void *edges,
                            int32_t room, enum pel_fill_rule rule)
{
    w->edge = edges;
    w->order = (int32_t *)(void *)(w->edge + room);
    w->sum = w->order + room;
    w->room = room;
    w->mask = rule == PEL_EVEN_ODD ? 1 : -1;
    w->row.right = 0;
    w->row.coverage = w->coverage;
    clear(w->sum, &w->smooth.target->clip);
}
