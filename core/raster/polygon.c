#include "polygon.h"

#include "collect.h"
#include "edge.h"

/* One edge of the outline, from its first visible row on. */
struct side {
    struct pel_edge edge;
    int32_t first, end; /* rows, half-open */
    int32_t winding;    /* +1 downwards, -1 upwards */
};

/* The scratch memory: n sides, then their order. order[0, active) are the
 * sides that cross the present row, by x; order[next, count) those to come, by
 * first row. active <= next always. */
struct sweep {
    struct side *side;
    int32_t *order;
    int32_t count, next, active;
    int32_t mask; /* of the winding number: 1 even-odd, -1 non-zero */
};

typedef char pel_polygon_side_fits[PEL_POLYGON_SCRATCH_SIZE(1) ==
                                           sizeof(struct side) + sizeof(int32_t)
                                       ? 1
                                       : -1];

size_t pel_polygon_scratch_size(int32_t n)
{
    if (n < 0 || (size_t)n > (size_t)-1 / PEL_POLYGON_SCRATCH_SIZE(1))
        return 0;
    return PEL_POLYGON_SCRATCH_SIZE(n);
}

static PEL_NOINLINE void add_side(struct sweep *w, const struct pel_point *a,
                                  const struct pel_point *b,
                                  const struct pel_rect *clip)
{
    struct side *s = &w->side[w->count];
    s->winding = 1;
    if (a->y > b->y) {
        const struct pel_point *t = a;
        a = b;
        b = t;
        s->winding = -1;
    }
    s->first = pel_max(pel_first_pixel(a->y), clip->y0);
    s->end = pel_min(pel_first_pixel(b->y), clip->y1);
    if (s->first >= s->end)
        return;
    pel_edge_start(&s->edge, a, b, s->first);
    w->order[w->count] = w->count;
    w->count++;
}

enum key { BY_FIRST_ROW, BY_X };

static int32_t key_of(const struct side *side, enum key key)
{
    return key == BY_X ? side->edge.x : side->first;
}

/* Shell sort of sides that are mixed, with gaps of 2^k - 1: O(n^1.5) moves.
 * From row to row few change places, so that insertion sort will do: no two
 * sides do it twice. */
static PEL_INLINE_KINDS void sort(struct sweep *w, int32_t count, enum key key,
                                  bool mixed)
{
    int32_t gap = 1;
    while (mixed && gap < count / 4)
        gap = 2 * gap + 1;
    for (; gap; gap /= 2)
        for (int32_t i = gap; i < count; i++) {
            const int32_t side = w->order[i], k = key_of(&w->side[side], key);
            int32_t j = i;
            for (; j >= gap && key_of(&w->side[w->order[j - gap]], key) > k;
                 j -= gap)
                w->order[j] = w->order[j - gap];
            w->order[j] = side;
        }
}

static int32_t first_of(const struct sweep *w, int32_t i)
{
    return w->side[w->order[i]].first;
}

/* Sides that begin in row y become active; false when there are none. */
static PEL_NOINLINE_32 bool enter(struct sweep *w, int32_t y)
{
    const int32_t next = w->next;
    for (; w->next < w->count && first_of(w, w->next) == y; w->next++) {
        const int32_t side = w->order[w->next];
        w->order[w->next] = w->order[w->active];
        w->order[w->active++] = side;
    }
    return w->next > next;
}

/* Spans begin where a side enters the polygon and end where one leaves it. */
static void emit_row(const struct sweep *w, struct pel_collector *c, int32_t y)
{
    int32_t winding = 0, start = 0;
    for (int32_t i = 0; i < w->active; i++) {
        const struct side *s = &w->side[w->order[i]];
        bool outside = (winding & w->mask) == 0;
        winding += s->winding;
        if (outside)
            start = s->edge.x;
        else if ((winding & w->mask) == 0)
            pel_collect_clipped(c, y, start, s->edge.x);
    }
}

/* Moves on to row y; sides that end there are dropped. */
static PEL_NOINLINE void advance(struct sweep *w, int32_t y)
{
    int32_t kept = 0;
    for (int32_t i = 0; i < w->active; i++) {
        struct side *s = &w->side[w->order[i]];
        if (s->end == y)
            continue;
        pel_edge_next(&s->edge);
        w->order[kept++] = w->order[i];
    }
    w->active = kept;
}

static void sweep_rows(struct sweep *w, struct pel_collector *c)
{
    int32_t y = 0;
    while (w->active || w->next < w->count) {
        if (w->active == 0)
            y = first_of(w, w->next);
        const bool mixed = enter(w, y);
        sort(w, w->active, BY_X, mixed);
        emit_row(w, c, y);
        advance(w, ++y);
    }
}

int pel_polygon_visible(const struct pel_polygon_shape *polygon,
                        const struct pel_rect *clip)
{
    const struct pel_rect box = pel_points_box(polygon->v, polygon->n);
    const struct pel_point corners[2] = {{box.x0, box.y0}, {box.x1, box.y1}};
    if (!pel_points_legal(corners, 2))
        return PEL_ERROR_RANGE;
    const struct pel_rect seen = pel_rect_pixels(&box, clip);
    return pel_rect_empty(&seen) ? PEL_OK : 1;
}

/* As pel_polygon_visible. */
static PEL_NOINLINE int check(const struct pel_polygon_shape *p,
                              const void *scratch, size_t size,
                              const struct pel_rect *clip)
{
    if (!p->v || !scratch)
        return PEL_ERROR_NULL;
    size_t needed = pel_polygon_scratch_size(p->n);
    if (needed == 0 || size < needed || (uintptr_t)scratch % 4)
        return PEL_ERROR_SCRATCH;
    PEL_HINT(pel_in_subpixels(p->v, p->n, 0));
    return pel_polygon_visible(p, clip);
}

enum pel_status pel_polygon(const struct pel_surface *surface,
                            const struct pel_polygon_shape *polygon,
                            const struct pel_paint *paint, void *scratch,
                            size_t size)
{
    if (!surface || !polygon || !paint)
        return PEL_ERROR_NULL;
    if (polygon->n < 3)
        return PEL_OK;
    const int visible = check(polygon, scratch, size, &surface->clip);
    if (visible <= 0)
        return (enum pel_status)visible;

    struct side *sides = scratch;
    struct sweep w = {sides, (int32_t *)(void *)(sides + polygon->n), 0, 0,
                      0,     polygon->rule == PEL_EVEN_ODD ? 1 : -1};
    const struct pel_point *previous = &polygon->v[polygon->n - 1];
    for (int32_t i = 0; i < polygon->n; i++) {
        add_side(&w, previous, &polygon->v[i], &surface->clip);
        previous = &polygon->v[i];
    }
    sort(&w, w.count, BY_FIRST_ROW, true);
    struct pel_collector c;
    pel_collect_begin(&c, surface, paint);
    sweep_rows(&w, &c);
    pel_collect_end(&c);
    return PEL_OK;
}
