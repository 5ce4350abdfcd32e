#include "sweep.h"

#include "collect.h"

bool pel_sweep_add(struct pel_sweep *w, const struct pel_point *a,
                   const struct pel_point *b, int32_t y0, int32_t y1)
{
    int32_t winding = 1;
    if (a->y > b->y) {
        const struct pel_point *t = a;
        a = b;
        b = t;
        winding = -1;
    }
    const int32_t first = pel_max(pel_first_pixel(a->y), y0);
    const int32_t end = pel_min(pel_first_pixel(b->y), y1);
    if (first >= end)
        return true;
    if (w->count == w->room)
        return false;
    struct pel_sweep_side *const s = pel_sweep_sides(w) + w->count;
    s->winding = winding;
    s->first = first;
    s->end = end;
    pel_edge_start(&s->edge, a, b, first);
    pel_sweep_order(w)[w->count] = w->count;
    w->count++;
    return true;
}

enum key { BY_FIRST_ROW, BY_X };

static int32_t key_of(const struct pel_sweep_side *side, enum key key)
{
    return key == BY_X ? side->edge.x : side->first;
}

/* Shell sort, with gaps of 2^k - 1, of sides that are mixed, as all are at
 * first and some where others have entered: O(n^1.5) moves. Else few change
 * places from row to row, and insertion sort will do: no two sides cross twice.
 */
static PEL_INLINE_KINDS void sort(struct pel_sweep *w, int32_t count,
                                  enum key key, bool mixed)
{
    const struct pel_sweep_side *const sides = pel_sweep_sides(w);
    int32_t *const order = pel_sweep_order(w);
    int32_t gap = 1;
    while (mixed && gap < count / 4)
        gap = 2 * gap + 1;
    for (; gap; gap /= 2)
        for (int32_t i = gap; i < count; i++) {
            const int32_t side = order[i], k = key_of(&sides[side], key);
            int32_t j = i;
            for (; j >= gap && key_of(&sides[order[j - gap]], key) > k;
                 j -= gap)
                order[j] = order[j - gap];
            order[j] = side;
        }
}

static struct pel_sweep_side *side_at(struct pel_sweep *w, int32_t i)
{
    return &pel_sweep_sides(w)[pel_sweep_order(w)[i]];
}

/* Sides that begin in row y become active; false when there are none. */
static PEL_NOINLINE_32 bool enter(struct pel_sweep *w, int32_t y)
{
    int32_t *const order = pel_sweep_order(w);
    const int32_t next = w->next;
    for (; w->next < w->count && side_at(w, w->next)->first == y; w->next++) {
        const int32_t side = order[w->next];
        order[w->next] = order[w->active];
        order[w->active++] = side;
    }
    return w->next > next;
}

/* Spans begin where a side enters the polygon and end where one leaves it. */
static void emit_row(struct pel_sweep *w, struct pel_collector *c, int32_t y)
{
    int32_t winding = 0, start = 0;
    for (int32_t i = 0; i < w->active; i++) {
        const struct pel_sweep_side *const s = side_at(w, i);
        bool outside = (winding & w->mask) == 0;
        winding += s->winding;
        if (outside)
            start = s->edge.x;
        else if ((winding & w->mask) == 0)
            pel_collect_clipped(c, y, start, s->edge.x);
    }
}

/* Moves on to row y; sides that end there are dropped. */
static PEL_NOINLINE void advance(struct pel_sweep *w, int32_t y)
{
    int32_t *const order = pel_sweep_order(w);
    int32_t kept = 0;
    for (int32_t i = 0; i < w->active; i++) {
        struct pel_sweep_side *const s = side_at(w, i);
        if (s->end == y)
            continue;
        pel_edge_next(&s->edge);
        order[kept++] = order[i];
    }
    w->active = kept;
}

static void sweep_rows(struct pel_sweep *w, struct pel_collector *c)
{
    int32_t y = 0;
    while (w->active || w->next < w->count) {
        if (w->active == 0)
            y = side_at(w, w->next)->first;
        const bool mixed = enter(w, y);
        sort(w, w->active, BY_X, mixed);
        emit_row(w, c, y);
        advance(w, ++y);
    }
}

enum pel_status pel_sweep_paint(struct pel_sweep *w,
                                const struct pel_surface *surface,
                                const struct pel_paint *paint)
{
    struct pel_collector c;
    sort(w, w->count, BY_FIRST_ROW, true);
    pel_collect_begin(&c, surface, paint);
    sweep_rows(w, &c);
    pel_collect_end(&c);
    w->count = w->next = 0;
    return PEL_OK;
}
