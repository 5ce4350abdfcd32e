#include "fast_triangle.h"

#include "../base/point.h"

#if PEL_FAST_FILLS

static int64_t floor_divide(int64_t n, int64_t d)
{
    int64_t q = n / d;
    return q - (n % d < 0);
}

/* At most 128 px high: one division. The edge crosses a row at
 * X = a.x + t dx / dy sub-pixels; x must be ceil((X - 128) / 256) =
 * floor(x') + 1 for any x' that lies below (X - 128) / 256 by less than the
 * distance of that number to the next integer below it. X dy is an integer, so
 * this distance is at least 1 / (256 dy) >= 2^-23 px = 512 steps of 2^-32 px.
 * x' starts 256 steps low; cutting the slope towards zero loses less than a
 * step a row and two at the start where x grows, and gains less than one at the
 * start and in each row after it where x falls; dy <= 2^15 means at most 128
 * rows: between 128 and 387 steps low, never 0 or 512. |dx| < 2^23, the width
 * of a surface, so the slope fits 2^55, and t <= 255 times it 2^63. An edge
 * that crosses no row centre, level ones included, gets a number that is never
 * used: cheaper than a branch that cannot be predicted. */
static PEL_ALWAYS_INLINE struct pel_slope start_short(const struct pel_point *a,
                                                      const struct pel_point *b)
{
    struct pel_slope e;
    int64_t dx = b->x - a->x, dy = b->y - a->y;
    int64_t t = pel_pixel_center(pel_first_pixel(a->y)) - a->y;
    e.step = dx * INT64_C(4294967296) / (dy + (dy == 0));
    e.x = (int64_t)(a->x - 128) * 16777216 + ((t * e.step) >> 8) +
          INT64_C(4294967296) - 256;
    return e;
}

/* At most 4,095 rows: two divisions. The integer part of the first row's x and
 * the rest m are exact, as in edge.h; x starts in the middle of the interval
 * of m, (m + 1/2) / dy, and the slope is rounded to the nearest.
 * Exact while rows (rows + 1) < 2^24: then the sum of slope errors, half a step
 * of 2^-32 each, stays below half of 1 / dy, dy < 256 (rows + 1). */
static struct pel_slope start_long(const struct pel_point *a,
                                   const struct pel_point *b)
{
    struct pel_slope e = {0, 0};
    int64_t dx = b->x - a->x, dy = b->y - a->y;
    int64_t t = pel_pixel_center(pel_first_pixel(a->y)) - a->y;
    if (t > dy || dy == 0)
        return e; /* crosses no row centre, is never walked */
    int64_t m = ((a->x - 128) * dy + t * dx - 1) >> 8;
    int64_t x = floor_divide(m, dy);
    e.x = (x + 1) * INT64_C(4294967296) +
          (2 * (m - x * dy) + 1) * INT64_C(2147483648) / dy;
    e.step = floor_divide(dx * INT64_C(8589934592) + dy, 2 * dy);
    return e;
}

/* True for a box inside the clip, whose vertices are then legal: a legal
 * coordinate ends 1/256 px before a clip that ends at 32,768 px. */
static bool inside(const struct pel_rect *clip, const struct pel_rect *box)
{
    return box->x0 >= PEL_PX(clip->x0) && box->y0 >= PEL_PX(clip->y0) &&
           box->x1 <= pel_min(PEL_PX(clip->x1), PEL_COORDINATE_MAX) &&
           box->y1 <= pel_min(PEL_PX(clip->y1), PEL_COORDINATE_MAX);
}

/* From top to bottom: the place of a vertex is how many lie above it; at one
 * height the order of v stays. pel_sort_rows is smaller, but has branches,
 * which CPUs cannot predict. */
static inline void sort(const struct pel_point v[3],
                        const struct pel_point *p[3])
{
    const int b = v[1].y < v[0].y, c = v[2].y < v[0].y, d = v[2].y < v[1].y;
    p[b + c] = &v[0];
    p[1 - b + d] = &v[1];
    p[2 - c - d] = &v[2];
}

/* Hands the rows to the paint, in batches. */
static void fill_rows(const struct pel_surface *surface,
                      const struct pel_fast_triangle *t,
                      const struct pel_paint *paint)
{
    struct pel_span span[PEL_BATCH_ROWS];
    struct pel_spans spans = {surface, span, t->y0, 0, 1};
    struct pel_slope whole = t->whole, half = t->upper;
    int32_t y = t->y0, stop = t->y1;
    for (; y < t->y2; spans.y = y) {
        const int32_t end = pel_min(y + PEL_BATCH_ROWS, t->y2);
        struct pel_span *out = span;
        spans.n = end - y;
        while (y < end) {
            if (y == stop) {
                stop = t->y2;
                half = t->lower;
            }
            for (const int32_t part = pel_min(stop, end); y < part; y++) {
                const int32_t p = (int32_t)(whole.x >> 32);
                const int32_t q = (int32_t)(half.x >> 32);
                whole.x += whole.step;
                half.x += half.step;
                out->x0 = p < q ? p : q;
                out->x1 = p < q ? q : p;
                out++;
            }
        }
        paint->fill(paint, &spans);
    }
}

bool pel_triangle_fast(const struct pel_surface *surface,
                       const struct pel_point v[3],
                       const struct pel_paint *paint)
{
    const struct pel_point *p[3];
    struct pel_fast_triangle t;
    sort(v, p);
    const struct pel_rect box = pel_corners_box(v);
    if (!inside(&surface->clip, &box) || box.y1 - box.y0 > PEL_PX(4094))
        return false;
    t.y0 = pel_first_pixel(p[0]->y);
    t.y1 = pel_first_pixel(p[1]->y);
    t.y2 = pel_first_pixel(p[2]->y);
    if (t.y0 >= t.y2)
        return true;
    if (box.y1 - box.y0 <= 32768) {
        t.whole = start_short(p[0], p[2]);
        t.upper = start_short(p[0], p[1]);
        t.lower = start_short(p[1], p[2]);
    } else {
        t.whole = start_long(p[0], p[2]);
        t.upper = start_long(p[0], p[1]);
        t.lower = start_long(p[1], p[2]);
    }
    if (!paint->fast || !paint->fast(paint, surface, &t))
        fill_rows(surface, &t, paint);
    return true;
}

#endif
