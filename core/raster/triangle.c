#include "triangle.h"

#include "edge.h"
#include "fast_triangle.h"
#include "triangle_sort.h"

/* One edge's column of a batch: its state stays in registers. */
static void walk(struct pel_edge *e, int32_t *x, int32_t n)
{
    struct pel_edge w = *e;
    do {
        *x = w.x;
        x += 2; /* the next row's x0, or x1 */
        pel_edge_next(&w);
    } while (--n);
    e->x = w.x;
    e->m = w.m;
}

/* Both edges follow one formula, so which is the left one does not matter
 * until here: a row is [min, max) of the two. */
static void order_and_clip(struct pel_row *row, int32_t n,
                           const struct pel_rect *clip)
{
    do {
        int32_t a = row->x0, b = row->x1;
        row->x0 = pel_max(pel_min(a, b), clip->x0);
        row->x1 = pel_min(pel_max(a, b), clip->x1);
        row++;
    } while (--n);
}

struct walker {
    const struct pel_surface *surface;
    const struct pel_paint *paint;
    struct pel_edge side[2];
};

/* Rows [y, end) between the two edges. */
static void fill_half(struct walker *w, int32_t y, int32_t end)
{
    struct pel_row row[PEL_BATCH_ROWS];
    struct pel_rows rows = {w->surface, row, y, 0, 1};
    for (; rows.y < end; rows.y += rows.n) {
        int32_t n = pel_min(end - rows.y, PEL_BATCH_ROWS);
        walk(&w->side[0], &row[0].x0, n);
        walk(&w->side[1], &row[0].x1, n);
        order_and_clip(row, n, &w->surface->clip);
        rows.n = (uint8_t)n;
        w->paint->fill(w->paint, &rows);
    }
}

void pel_triangle(const struct pel_surface *surface,
                  const struct pel_point v[3], const struct pel_paint *paint)
{
    PEL_ASSERT(pel_points_legal(v, 3));
    if (!pel_points_legal(v, 3))
        return;
    if (pel_fast_triangle(surface, v, paint))
        return;
    const struct pel_point *top, *middle, *bottom;
    pel_sort3(v, &top, &middle, &bottom);

    struct walker w;
    int32_t y = pel_max(pel_first_pixel(top->y), surface->clip.y0);
    int32_t end = pel_min(pel_first_pixel(bottom->y), surface->clip.y1);
    int32_t bend = pel_min(pel_first_pixel(middle->y), end);
    if (y >= end)
        return;
    w.surface = surface;
    w.paint = paint;
    pel_edge_start(&w.side[0], top, bottom, y);
    if (y < bend) {
        pel_edge_start(&w.side[1], top, middle, y);
        fill_half(&w, y, bend);
        y = bend;
    }
    if (y < end) {
        pel_edge_start(&w.side[1], middle, bottom, y);
        fill_half(&w, y, end);
    }
}
