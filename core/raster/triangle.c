#include "triangle.h"

#include "edge.h"
#include "triangle_sort.h"

/* The edges of a triangle in a row: the long one, from top to bottom, and
 * opposite a short one, from p[0] to p[1] and then from p[1] to p[2]. */
struct walk {
    struct pel_edge long_edge, short_edge;
    const struct pel_point **to; /* where the short edge ends */
    int32_t end;                 /* first row below it */
};

/* A batch of spans, and the same as numbers: x0 and x1 of each. */
union batch {
    struct pel_span span[PEL_BATCH_ROWS];
    int32_t x[PEL_BATCH_ROWS * 2];
};

/* Writes x of an edge in n rows to every other number of a batch. Edges are
 * walked one by one, so that the state of one stays in registers. */
static PEL_INLINE_LOOP void walk_edge(struct pel_edge *edge, int32_t *x,
                                      int32_t n)
{
    struct pel_edge e = *edge;
    int32_t *const end = x + 2 * n;
    do {
        *x = e.x;
        x += 2;
        pel_edge_next(&e);
    } while (x < end);
    edge->x = e.x;
    edge->m = e.m;
}

static void start_short(struct walk *w, const struct pel_point **to, int32_t y)
{
    w->to = to;
    w->end = pel_first_pixel(to[0]->y);
    pel_edge_start(&w->short_edge, to[-1], to[0], y);
}

/* Walks n > 0 rows from y on, in which one short edge may follow the other. */
static void walk_short(struct walk *w, int32_t y, int32_t *x, int32_t n)
{
    for (;;) {
        int32_t k = pel_min(w->end - y, n);
        walk_edge(&w->short_edge, x, k);
        n -= k;
        if (n == 0)
            return;
        x += 2 * k;
        y += k;
        start_short(w, w->to + 1, y);
    }
}

/* Orders the ends of spans, as either edge may be the left one, and clips. */
static void order(struct pel_span *span, int32_t n, const struct pel_rect *clip)
{
    const int32_t left = clip->x0, right = clip->x1;
    do {
        int32_t a = span->x0, b = span->x1;
        span->x0 = pel_max(pel_min(a, b), left);
        span->x1 = pel_min(pel_max(a, b), right);
        span++;
    } while (--n);
}

/* Side of the long edge. UNKNOWN: spans must be ordered and clipped, which
 * costs time and changes no pixel. */
enum side { LEFT, RIGHT, UNKNOWN };

/* The middle vertex is right or left of both others, and the long edge
 * opposite, or the sign of a cross product decides, if that fits 32 bits.
 * UNKNOWN also when the clip cuts at the left or right. */
static enum side side_of(const struct pel_point *const p[3],
                         const struct pel_rect *clip)
{
    const int32_t a = p[0]->x, b = p[1]->x, c = p[2]->x;
    const int32_t dy = p[1]->y - p[0]->y, height = p[2]->y - p[0]->y;
    int32_t low = pel_min(a, c), high = pel_max(a, c);
    enum side side = b > low ? LEFT : RIGHT;
    if (!PEL_KNOW_SIDES)
        return UNKNOWN;
    if (b > low && b < high) {
        if ((height | (high - low)) >> 15)
            return UNKNOWN;
        side = (b - a) * height < (c - a) * dy ? RIGHT : LEFT;
    }
    low = pel_min(low, b);
    high = pel_max(high, b);
    if (pel_first_pixel(low) < clip->x0 || pel_first_pixel(high) > clip->x1)
        return UNKNOWN;
    return side;
}

static void fill(const struct pel_surface *surface,
                 const struct pel_paint *paint, const struct pel_point *p[3],
                 int32_t y, int32_t bottom)
{
    const enum side side = side_of(p, &surface->clip);
    union batch batch;
    struct pel_spans spans = {surface, batch.span, y, 0, 1};
    struct walk w;
    pel_edge_start(&w.long_edge, p[0], p[2], y);
    start_short(&w, y < pel_first_pixel(p[1]->y) ? p + 1 : p + 2, y);
    for (; spans.y < bottom; spans.y += spans.n) {
        spans.n = pel_min(bottom - spans.y, PEL_BATCH_ROWS);
        walk_edge(&w.long_edge, batch.x + (side == RIGHT), spans.n);
        walk_short(&w, spans.y, batch.x + (side != RIGHT), spans.n);
        if (side == UNKNOWN)
            order(batch.span, spans.n, &surface->clip);
        paint->fill(paint, &spans);
    }
}

void pel_triangle(const struct pel_surface *surface,
                  const struct pel_point v[3], const struct pel_paint *paint)
{
    if (PEL_FAST_FILLS && pel_triangle_fast(surface, v, paint))
        return;
    PEL_ASSERT(pel_corners_legal(v));
    if (!pel_corners_legal(v))
        return;
    const struct pel_point *p[3] = {&v[0], &v[1], &v[2]};
    pel_sort_rows(p);
    int32_t y = pel_max(pel_first_pixel(p[0]->y), surface->clip.y0);
    int32_t bottom = pel_min(pel_first_pixel(p[2]->y), surface->clip.y1);
    if (y < bottom)
        fill(surface, paint, p, y, bottom);
}
