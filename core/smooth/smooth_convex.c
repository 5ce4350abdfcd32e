/* Convex polygons, by the closed form of smooth_edge.h: row by row the pixels
 * that the left side crosses, full ones, and those that the right side crosses.
 */
#include "smooth_convex.h"

#include "short_walk.h"
#include "smooth_walk.h"

static bool has_edge(const struct pel_smooth_walk *k, int i)
{
    return k->side[i].edge.from != k->side[i].edge.to;
}

/* How far down edges cross whole rows on both sides, and how many such rows a
 * batch has room for. */
static void look_down(struct pel_smooth_walk *k)
{
    k->whole = k->end;
    k->rows = (uint8_t)pel_smooth_room(k);
    for (int i = 0; i < 2; i++) {
        const struct pel_smooth_vertices *const edge = &k->side[i].edge;
        k->whole = pel_min(k->whole, pel_pixel_of(k->v[edge->to].y));
        if (edge->from == edge->to || k->v[edge->from].y > PEL_PX(k->y))
            k->rows = 0;
    }
}

/* On to the edges that row k->y begins with. */
static void next_edges(struct pel_smooth_walk *k)
{
    bool next = false;
    for (int i = 0; i < 2; i++)
        while (has_edge(k, i) && k->v[k->side[i].edge.to].y <= PEL_PX(k->y)) {
            pel_smooth_next_edge(k, i);
            next = true;
        }
    if (next)
        look_down(k);
}

/* Begins at the top, and moves on to row k->y, if that is below. */
static void start(struct pel_smooth_walk *k, int i, int32_t top)
{
    struct pel_smooth_chain *const s = &k->side[i];
    s->edge.to = top;
    do
        pel_smooth_next_edge(k, i);
    while (s->edge.from != s->edge.to && k->v[s->edge.to].y <= PEL_PX(k->y));
    const int32_t above = k->v[s->edge.from].y, first = (above + 255) >> 8;
    if (s->edge.from == s->edge.to || above >= PEL_PX(k->y))
        return;
    pel_smooth_go_down(s, PEL_PX(first) - above);
    s->at += (int64_t)pel_times((uint64_t)s->step, k->y - first);
}

/* Twice the signed area: positive when clockwise on screen. It is below 2^50
 * for outlines that go around once; others may wrap. */
static int64_t area_of(const struct pel_point *v, int32_t n)
{
    uint64_t area = 0;
    for (int32_t i = 2; i < n; i++)
        area += (uint64_t)(pel_product(v[i - 1].x - v[0].x, v[i].y - v[0].y) -
                           pel_product(v[i - 1].y - v[0].y, v[i].x - v[0].x));
    return (int64_t)area;
}

/* Is nothing of the box in the clip; is all of it, left and right? */
static bool is_beside(const struct pel_rect *box, const struct pel_rect *clip)
{
    return pel_pixel_of(box->x1) < clip->x0 ||
           pel_pixel_of(box->x0) >= clip->x1;
}

static bool is_inside(const struct pel_rect *box, const struct pel_rect *clip)
{
    return pel_pixel_of(box->x0) >= clip->x0 &&
           pel_pixel_of(box->x1) < clip->x1;
}

/* The first vertex at a height. */
static int32_t vertex_at(const struct pel_point *v, int32_t y)
{
    int32_t i = 0;
    while (v[i].y != y)
        i++;
    return i;
}

static PEL_NOINLINE_32 bool is_legal(const struct pel_point *v, int32_t n)
{
    const bool legal = pel_points_legal(v, n);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(v, n, 0));
    return legal;
}

/* An outline's box and the rows of it that are drawn, x0 to x1; and which way
 * it goes round: 1, or -1; or 0, where nothing is to be seen. */
static int8_t find_rows(const struct pel_rect *clip, const struct pel_point *v,
                        int32_t n, struct pel_rect *box, struct pel_span *rows)
{
    const int64_t area = area_of(v, n);
    *box = pel_points_box(v, n);
    rows->x0 = pel_max(pel_pixel_of(box->y0), clip->y0);
    rows->x1 = pel_min(pel_pixel_of(box->y1 + 255), clip->y1);
    if (rows->x0 >= rows->x1 || is_beside(box, clip))
        return 0;
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

PEL_NOINLINE bool pel_smooth_short_begin(struct pel_smooth_short_walk *k,
                                         const struct pel_surface *surface,
                                         const struct pel_point *v, int32_t n)
{
    struct pel_rect box;
    struct pel_span rows;
    if (!pel_smooth_begin(&k->pixels.smooth, surface, k->pixels.smooth.paint) ||
        n < 3)
        return false;
    const int8_t turn = find_rows(&surface->clip, v, n, &box, &rows);
    if (turn == 0)
        return false;
    k->backwards = turn < 0;
    k->pixels.y = rows.x0;
    k->side[0].from = k->side[1].from = vertex_at(v, box.y0);
    return true;
}

/* Both from the first vertex at the top. False: nothing is to be seen. */
static PEL_NOINLINE_32 bool start_walk(struct pel_smooth_walk *k)
{
    const struct pel_rect *const clip = &k->smooth.target->clip;
    struct pel_rect box;
    struct pel_span rows;
    k->turn = find_rows(clip, k->v, k->n, &box, &rows);
    if (k->turn == 0)
        return false;
    const int32_t top = vertex_at(k->v, box.y0);
    k->y = rows.x0;
    k->end = rows.x1;
    k->inside = is_inside(&box, clip);
    k->rest = (struct pel_span){0, 0};
    start(k, 0, top);
    start(k, 1, top);
    look_down(k);
    return true;
}

/* Begins with v, n and the paint. False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(struct pel_smooth_walk *k,
                                  const struct pel_surface *surface)
{
    return is_legal(k->v, k->n) &&
           pel_smooth_begin(&k->smooth, surface, k->smooth.paint) &&
           k->n >= 3 && start_walk(k);
}

/* Makes the next batch of whole rows, or goes on to what is left of a row that
 * is not; false at the end. */
static PEL_NOINLINE_32 bool next_rows(struct pel_smooth_walk *k)
{
    while (k->rest.x0 >= k->rest.x1) {
        if (k->y >= k->end)
            return false;
        next_edges(k);
        const int32_t n = pel_min(k->whole - k->y, k->rows);
        if (n > 0) {
            pel_smooth_cross(k, n);
            return true;
        }
        pel_smooth_pass_row(k);
        look_down(k);
    }
    return true;
}

static PEL_NOINLINE bool begin_short(struct pel_smooth_short_walk *k,
                                     const struct pel_surface *surface)
{
    return is_legal(k->shape.v, k->of.n) &&
           pel_smooth_short_begin(k, surface, k->shape.v, k->of.n);
}

static PEL_ALWAYS_INLINE void paint_short(const struct pel_surface *surface,
                                          const struct pel_point *v, int32_t n,
                                          const struct pel_paint *paint)
{
    struct pel_smooth_short_walk k;
    k.shape.v = v;
    k.of.n = n;
    k.line = false;
    k.pixels.smooth.paint = paint;
    if (begin_short(&k, surface))
        pel_smooth_short_paint(&k);
}

static PEL_ALWAYS_INLINE void paint_batches(const struct pel_surface *surface,
                                            const struct pel_point *v,
                                            int32_t n,
                                            const struct pel_paint *paint)
{
    struct pel_smooth_walk k;
    k.v = v;
    k.n = n;
    k.smooth.paint = paint;
    if (!begin(&k, surface))
        return;
    while (next_rows(&k)) {
        if (k.rest.x0 < k.rest.x1)
            pel_smooth_rest_of_row(&k);
        pel_smooth_paint_batch(&k.smooth, &k.of.batch);
    }
}

/* Inlined twice, for less stack. */
static PEL_ALWAYS_INLINE void paint_outline(const struct pel_surface *surface,
                                            const struct pel_point *v,
                                            int32_t n,
                                            const struct pel_paint *paint)
{
    if (PEL_SMOOTH_TINY)
        paint_short(surface, v, n, paint);
    else
        paint_batches(surface, v, n, paint);
}

void pel_smooth_convex(const struct pel_surface *surface,
                       const struct pel_point *v, int32_t n,
                       const struct pel_paint *paint)
{
    paint_outline(surface, v, n, paint);
}

void pel_smooth_triangle(const struct pel_surface *surface,
                         const struct pel_point v[3],
                         const struct pel_paint *paint)
{
    paint_outline(surface, v, 3, paint);
}
