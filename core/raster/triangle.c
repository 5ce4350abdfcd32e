#include "triangle.h"

#include "edge.h"
#include "fast_triangle.h"
#include "triangle_sort.h"

/* A batch is walked edge by edge, so that the state of one edge stays in
 * registers: first the long edge into the x0 of every row. */
static void walk_long(struct pel_edge *edge, struct pel_row *row, int32_t n)
{
    struct pel_edge e = *edge;
    do {
        row->x0 = e.x;
        row++;
        pel_edge_next(&e);
    } while (--n);
    edge->x = e.x;
    edge->m = e.m;
}

/* Then the other edge. Both follow one formula, so which of them is the left
 * one is decided here: a row is [min, max) of the two, inside the clip. */
static PEL_WALK void walk_short(struct pel_edge *edge, struct pel_row *row,
                                int32_t n, const struct pel_rect *clip)
{
    struct pel_edge e = *edge;
    const int32_t left = clip->x0, right = clip->x1;
    do {
        int32_t x = row->x0;
        row->x0 = pel_max(pel_min(x, e.x), left);
        row->x1 = pel_min(pel_max(x, e.x), right);
        row++;
        pel_edge_next(&e);
    } while (--n);
    edge->x = e.x;
    edge->m = e.m;
}

/* Rows [y, end) between the long edge, side[0], and the short one. */
static void fill_half(const struct pel_surface *surface,
                      const struct pel_paint *paint, struct pel_edge side[2],
                      int32_t y, int32_t end)
{
    struct pel_row row[PEL_BATCH_ROWS];
    struct pel_rows rows;
    rows.surface = surface;
    rows.row = row;
    rows.step = 1;
    for (rows.y = y; rows.y < end; rows.y += rows.n) {
        int32_t n = pel_min(end - rows.y, PEL_BATCH_ROWS);
        walk_long(&side[0], row, n);
        walk_short(&side[1], row, n, &surface->clip);
        rows.n = n;
        paint->fill(paint, &rows);
    }
}

void pel_triangle(const struct pel_surface *surface,
                  const struct pel_point v[3], const struct pel_paint *paint)
{
    if (pel_fast_triangle(surface, v, paint))
        return;
    PEL_ASSERT(pel_points_legal(v, 3));
    if (!pel_points_legal(v, 3))
        return;
    const struct pel_point *p[3] = {&v[0], &v[1], &v[2]};
    struct pel_edge side[2];
    pel_sort_rows(p);
    int32_t y = pel_max(pel_first_pixel(p[0]->y), surface->clip.y0);
    int32_t bottom = pel_min(pel_first_pixel(p[2]->y), surface->clip.y1);
    if (y >= bottom)
        return;
    pel_edge_start(&side[0], p[0], p[2], y);
    for (int half = 0; half < 2; half++) {
        int32_t end = pel_min(pel_first_pixel(p[half + 1]->y), bottom);
        if (y >= end)
            continue;
        pel_edge_start(&side[1], p[half], p[half + 1], y);
        fill_half(surface, paint, side, y, end);
        y = end;
    }
}
