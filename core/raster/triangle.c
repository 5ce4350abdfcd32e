#include "triangle.h"

#include "sides.h"
#include "triangle_sort.h"

/* Side of the long edge. UNKNOWN: spans must be ordered and clipped, which
 * costs time and changes no pixel. BESIDE: there are none, as the triangle lies
 * left or right of the clip. */
enum side { LEFT, RIGHT, UNKNOWN, BESIDE };

/* Opposite the middle vertex, where that is right or left of both others;
 * elsewhere by the sign of a cross product, if that fits 32 bits. UNKNOWN also
 * when the clip cuts at the left or right. */
static enum side side_of(const struct pel_point *const p[3],
                         const struct pel_rect *clip)
{
    const int32_t a = p[0]->x, b = p[1]->x, c = p[2]->x;
    const int32_t dy = p[1]->y - p[0]->y, height = p[2]->y - p[0]->y;
    int32_t low = pel_min(a, c), high = pel_max(a, c);
    enum side side = b > low ? LEFT : RIGHT;
    if (PEL_SMALL_CODE)
        return UNKNOWN;
    if (b > low && b < high) {
        if ((height | (high - low)) >> 15)
            side = UNKNOWN;
        else
            side = (b - a) * height < (c - a) * dy ? RIGHT : LEFT;
    }
    low = pel_first_pixel(pel_min(low, b));
    high = pel_first_pixel(pel_max(high, b));
    if (low >= clip->x0 && high <= clip->x1)
        return side;
    return low < clip->x1 && high > clip->x0 ? UNKNOWN : BESIDE;
}

static void fill(const struct pel_surface *surface,
                 const struct pel_paint *paint, const struct pel_point *p[3],
                 int32_t y, int32_t bottom)
{
    const enum side side = side_of(p, &surface->clip);
    union pel_batch batch;
    struct pel_spans spans = {surface, batch.span, y, 0, 1};
    struct pel_edge edge; /* the long one, from top to bottom */
    struct pel_side short_side;
    if (side == BESIDE)
        return;
    short_side.end = p[1];
    short_side.last = p[2];
    pel_edge_start(&edge, p[0], p[2], y);
    pel_side_start(&short_side, p[0], y);
    for (; spans.y < bottom; spans.y += spans.n) {
        spans.n = pel_min(bottom - spans.y, PEL_ROWS);
        pel_edge_walk(&edge, batch.x + (side == RIGHT), spans.n);
        pel_side_walk(&short_side, spans.y, batch.x + (side != RIGHT), spans.n);
        if (side == UNKNOWN)
            pel_spans_order(batch.span, spans.n, &surface->clip);
        paint->fill(paint, &spans);
    }
}

/* In little code: false also when it lies left or right of the clip, by a pixel
 * or more. */
static inline bool in_sight(const struct pel_point v[3],
                            const struct pel_rect *clip)
{
    int32_t left = -1, right = 0; /* below 0: all are, some vertex is not */
    for (int i = 2; i >= 0; i--) {
        if (!pel_point_legal(v[i]))
            return false;
        left &= (v[i].x >> 8) - clip->x0;
        right |= (v[i].x >> 8) - clip->x1;
    }
    return left >= 0 && right < 0;
}

void pel_triangle(const struct pel_surface *surface,
                  const struct pel_point v[3], const struct pel_paint *paint)
{
    PEL_HINT(pel_in_subpixels(v, 3, 0));
    if (PEL_FAST_FILLS && pel_triangle_fast(surface, v, paint))
        return;
    PEL_ASSERT(pel_corners_legal(v));
    if (PEL_SMALL_CODE ? !in_sight(v, &surface->clip) : !pel_corners_legal(v))
        return;
    const struct pel_point *p[3] = {&v[0], &v[1], &v[2]};
    pel_sort_rows(p);
    int32_t y = pel_max(pel_first_pixel(p[0]->y), surface->clip.y0);
    int32_t bottom = pel_min(pel_first_pixel(p[2]->y), surface->clip.y1);
    if (y < bottom)
        fill(surface, paint, p, y, bottom);
}
