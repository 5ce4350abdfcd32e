#include "probe.h"

#include <stdlib.h>

#include "cases.h"
#include "check.h"
#include "reference.h"

static void check_row(struct probe *p, int32_t y, int32_t x0, int32_t x1)
{
    const struct pel_rect *clip = &p->surface.clip;
    const struct pel_point *v = p->v;
    const bool upper = pel_pixel_center(y) < v[1].y;
    const int32_t a = reference_edge_at(&v[0], &v[2], y);
    const int32_t b =
        reference_edge_at(&v[upper ? 0 : 1], &v[upper ? 1 : 2], y);
    const int32_t left = pel_max(pel_min(a, b), clip->x0);
    const int32_t right = pel_min(pel_max(a, b), clip->x1);
    p->rows++;
    if (x0 >= x1 && left >= right)
        return;
    if (x0 != left || x1 != right)
        fail_msg("%d,%d %d,%d %d,%d: row %d: expected %d..%d, got %d..%d; %s",
                 v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y, y, left, right,
                 x0, x1, cases_replay());
}

static void take_rows(const struct pel_paint *paint,
                      const struct pel_spans *rows)
{
    struct probe *p = (struct probe *)(uintptr_t)paint;
    for (int i = 0; i < rows->n; i++)
        check_row(p, rows->y + i * rows->step, rows->span[i].x0,
                  rows->span[i].x1);
}

void probe_open(struct probe *p)
{
    static uint8_t nothing;
    const struct pel_rect bounds = {-16384, -16384, 16383, 16383};
    *p = (struct probe){.paint = {take_rows, NULL}};
    assert_int_equal(pel_surface_init_rect(&p->surface, &pel_gray8, &nothing,
                                           32767, &bounds),
                     PEL_OK);
}

static int by_height(const void *a, const void *b)
{
    const struct pel_point *p = a, *q = b;
    return p->y != q->y ? (p->y > q->y) - (p->y < q->y)
                        : (p->x > q->x) - (p->x < q->x);
}

void probe_triangle(struct probe *p, const struct pel_point v[3])
{
    for (int i = 0; i < 3; i++)
        p->v[i] = v[i];
    qsort(p->v, 3, sizeof p->v[0], by_height);
    if (PEL_FAST_FILLS && pel_triangle_fast(&p->surface, v, &p->paint))
        p->fast++;
    else
        pel_triangle(&p->surface, v, &p->paint);
}
