#include "smooth_ring.h"

#include "ring_rows.h"

enum { WINDOW = PEL_SMOOTH_WINDOW };

/* A half of a row, from the axis on; that on the left in the mirrored picture.
 */
struct half {
    int32_t center;
    bool left;
    struct pel_span near; /* columns that the hole's side crosses, and .. */
    struct pel_span full; /* .. with no full ones between them .. */
    struct pel_span far;  /* .. that of the disc, in `near` */
};

/* The coverage of a window of columns, as in round_rows.c. */
static PEL_NOINLINE uint32_t cross(const struct pel_smooth_ring_walk *ring,
                                   int32_t center,
                                   const struct pel_span *columns, uint8_t *to,
                                   int32_t step)
{
    uint16_t area[WINDOW], hole[WINDOW];
    const int32_t n = pel_smooth_window(columns);
    pel_smooth_strips_areas(&ring->rows.strips, center, columns->x0, n, area);
    pel_smooth_strips_areas(&ring->hole, center, columns->x0, n, hole);
    for (int32_t i = 0; i < n; i++, to += step)
        *to = pel_smooth_coverage((uint32_t)(area[i] - hole[i]));
    return (uint32_t)(area[0] - hole[0]);
}

static void find_half(const struct pel_smooth_ring_walk *ring, struct half *h,
                      bool left)
{
    const struct pel_rect *const clip = &ring->rows.smooth.surface.clip;
    const int32_t x0 = left ? -clip->x1 : clip->x0;
    const int32_t x1 = left ? -clip->x0 : clip->x1;
    h->left = left;
    h->center = left ? -ring->outer.left : ring->outer.left;
    h->near = pel_smooth_strips_side(&ring->hole, h->center);
    h->far = pel_smooth_strips_side(&ring->rows.strips, h->center);
    if (h->far.x0 <= h->near.x1 ||
        pel_smooth_strips_height(&ring->rows.strips) != 32768)
        h->near.x1 = h->far.x0 = h->far.x1;
    h->full = (struct pel_span){h->near.x1, h->far.x0};
    h->near = pel_smooth_clipped(h->near, x0, x1);
    h->full = pel_smooth_clipped(h->full, x0, x1);
    h->far = pel_smooth_clipped(h->far, x0, x1);
}

/* The coverage of a window of columns whose first one is the nth of the right
 * half's bytes. */
static void cross_half(struct pel_smooth_ring_walk *ring, const struct half *h,
                       const struct pel_span *columns, int32_t first)
{
    uint8_t *const middle = ring->rows.coverage + WINDOW;
    if (pel_smooth_empty(columns))
        return;
    if (h->left)
        cross(ring, h->center, columns, middle - 1 - first, -1);
    else
        cross(ring, h->center, columns, middle + first, 1);
}

/* Paints n near columns, full ones and k far ones, which are taken away. */
static void paint_part(struct pel_smooth_ring_walk *ring, struct half *h,
                       int32_t n, int32_t full, int32_t k)
{
    const int32_t x = n ? h->near.x0 : full ? h->full.x0 : h->far.x0;
    uint8_t *const middle = ring->rows.coverage + WINDOW;
    struct pel_smooth_row row = {ring->rows.rows.x0, x, n, full, k, middle - n};
    if (h->left)
        row = (struct pel_smooth_row){row.y, -x - n - full - k, k, full,
                                      n,     middle - k};
    if (n)
        cross_half(ring, h, &h->near, -n);
    if (k)
        cross_half(ring, h, &h->far, 0);
    pel_smooth_rows_put(&ring->rows, &row);
    h->near.x0 += n;
    h->far.x0 += k;
}

static void paint_half(struct pel_smooth_ring_walk *ring, struct half *h)
{
    const int32_t full = pel_max(h->full.x1 - h->full.x0, 0);
    while (h->near.x1 - h->near.x0 > WINDOW)
        paint_part(ring, h, WINDOW, 0, 0);
    paint_part(ring, h, pel_smooth_window(&h->near), full,
               pel_smooth_window(&h->far));
    while (!pel_smooth_empty(&h->far))
        paint_part(ring, h, 0, 0, pel_smooth_window(&h->far));
}

static uint32_t first_area(const struct pel_smooth_ring_walk *ring,
                           const struct half *h)
{
    const struct pel_span column = {h->near.x0, h->near.x0 + 1};
    uint8_t unused;
    return cross(ring, h->center, &column, &unused, 1);
}

/* The column in the middle, where it belongs to both halves. */
static void paint_shared(struct pel_smooth_ring_walk *ring, struct half *l,
                         struct half *r)
{
    struct pel_smooth_rows *const rows = &ring->rows;
    struct pel_smooth_row row = {rows->rows.x0, r->near.x0, 1, 0, 0,
                                 rows->coverage};
    const uint32_t height = pel_smooth_strips_height(&rows->strips) -
                            pel_smooth_strips_height(&ring->hole);
    *rows->coverage =
        pel_smooth_coverage(first_area(ring, l) + first_area(ring, r) - height);
    pel_smooth_rows_put(rows, &row);
    l->near.x0++;
    r->near.x0++;
}

static void paint_row(struct pel_smooth_ring_walk *ring)
{
    struct half l, r;
    if (ring->rows.strips.n == 0 || ring->hole.n == 0) {
        pel_smooth_rows_paint(&ring->rows, &ring->outer);
        return;
    }
    find_half(ring, &l, true);
    find_half(ring, &r, false);
    if (-1 - l.near.x0 == r.near.x0 && !pel_smooth_empty(&r.near))
        paint_shared(ring, &l, &r);
    paint_half(ring, &l);
    paint_half(ring, &r);
}

static bool is_legal(const struct pel_ring_shape *ring)
{
    return pel_point_legal(ring->center) && pel_radius_legal(ring->inner) &&
           pel_radius_legal(ring->outer);
}

void pel_smooth_ring_rows(struct pel_smooth_ring_walk *ring)
{
    struct pel_span *const rows = &ring->rows.rows;
    pel_smooth_strips_start(&ring->hole, &ring->inner, rows->x0);
    for (; rows->x0 < rows->x1; rows->x0++) {
        pel_smooth_strips_row(&ring->rows.strips, &ring->outer, rows->x0);
        pel_smooth_strips_row(&ring->hole, &ring->inner, rows->x0);
        paint_row(ring);
    }
}

bool pel_smooth_ring_begin(struct pel_smooth_ring_walk *ring,
                           const struct pel_surface *surface,
                           const struct pel_ring_shape *shape,
                           const struct pel_paint *paint)
{
    const struct pel_point c = shape->center;
    ring->outer = (struct pel_smooth_round){c.x, c.x, c.y, c.y, shape->outer};
    ring->inner = ring->outer;
    ring->inner.radius = shape->inner;
    return pel_smooth_rows_begin(&ring->rows, surface, &ring->outer, paint);
}

void pel_smooth_ring(const struct pel_surface *surface,
                     const struct pel_ring_shape *shape,
                     const struct pel_paint *paint)
{
    const bool legal = is_legal(shape);
    struct pel_smooth_ring_walk ring;
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(&shape->center, 1, shape->outer));
    if (legal && shape->outer > shape->inner &&
        pel_smooth_ring_begin(&ring, surface, shape, paint))
        pel_smooth_ring_rows(&ring);
}
