/* Convex polygons, by the closed form of smooth_edge.h: row by row the pixels
 * that the left side crosses, full ones, and those that the right side crosses.
 */
#include "smooth_convex.h"

#include "smooth_walk.h"

static inline int32_t pixel_of(int64_t at)
{
    return (int32_t)(at >> 32);
}

static inline uint32_t fraction_at(int64_t at)
{
    return (uint32_t)at >> 16;
}

/* flip: 0, or all ones for the negative: what lies left of an edge. */
static inline uint32_t *put_area(uint32_t *to, uint32_t area, uint32_t flip)
{
    *to = ((PEL_SMOOTH_HALF + area) ^ flip) - flip;
    return to + 1;
}

/* Writes the areas inside a side, and HALF, of the pixels that it crosses, and
 * moves on to the next row. flip: 0 left, all ones right. */
static PEL_INLINE_KINDS uint32_t *cross_row(struct pel_smooth_side *s,
                                            uint32_t *area, uint32_t flip,
                                            int32_t *first)
{
    const int64_t from = s->at, to = from + s->step;
    const int64_t lo = s->step < 0 ? to : from, hi = s->step < 0 ? from : to;
    const uint32_t low = fraction_at(lo), high = fraction_at(hi);
    int32_t n = pixel_of(hi) - pixel_of(lo);
    s->at = to;
    *first = pixel_of(lo);
    if (n == 0)
        return put_area(area, PEL_SMOOTH_FULL - (low + high) * 32640, flip);
    area = put_area(area, pel_smooth_corner(&s->rise, 65536 - low), flip);
    if (n > 1) {
        uint32_t v = pel_smooth_between(&s->rise, 65536 - low);
        for (; n > 1; n--, v += s->rise.value)
            area = put_area(area, v, flip);
    }
    return put_area(area, PEL_SMOOTH_FULL - pel_smooth_corner(&s->rise, high),
                    flip);
}

/* Pixels that both sides cross: the last of the left one and the first of the
 * right one. Returns the end. */
static uint32_t *merge(uint32_t *area, uint32_t *middle, const uint32_t *end,
                       int32_t shared)
{
    const uint32_t *from = middle;
    if (shared > middle - area) /* by rounding: nothing is between them */
        return area;
    uint32_t *to = middle - shared;
    for (; to < middle && from < end; to++)
        *to += *from++ + PEL_SMOOTH_HALF;
    while (from < end)
        *to++ = *from++;
    return to;
}

void pel_smooth_cross_rows(struct pel_smooth_walk *k, int32_t y, int32_t n)
{
    uint32_t area[2 * PEL_SMOOTH_WIDE];
    uint8_t *const bytes = (uint8_t *)area;
    struct pel_smooth_row row = {y, 0, 0, 0, 0, bytes};
    for (; n > 0; n--, row.y++) {
        int32_t right;
        uint32_t *const middle = cross_row(&k->side[0], area, 0, &row.x);
        uint32_t *end = cross_row(&k->side[1], middle, ~UINT32_C(0), &right);
        row.left = (int32_t)(middle - area);
        row.right = (int32_t)(end - middle);
        row.full = right - row.x - row.left;
        if (row.full < 0) {
            end = merge(area, middle, end, -row.full);
            row.left = (int32_t)(end - area);
            row.right = row.full = 0;
        }
        for (int32_t i = 0; i < row.left + row.right; i++)
            bytes[i] = (uint8_t)(area[i] >> 24);
        if (k->inside)
            pel_smooth_paint(&k->smooth, &row);
        else
            pel_smooth_paint_clipped(&k->smooth, &row);
    }
}

/* Does the edge cross few pixels in each row? */
static bool is_narrow(const struct pel_smooth_side *s)
{
    return s->step >> 32 < PEL_SMOOTH_WIDE - 2 &&
           s->step >> 32 >= 2 - PEL_SMOOTH_WIDE;
}

/* Whole rows from y on that edges cross on both sides. */
static int32_t rows_across(const struct pel_smooth_walk *k, int32_t y,
                           int32_t end)
{
    for (int i = 0; i < 2; i++) {
        const struct pel_smooth_side *const s = &k->side[i];
        if (s->from == s->to || k->v[s->from].y > PEL_PX(y) || !is_narrow(s))
            return 0;
        end = pel_min(end, pel_pixel_of(k->v[s->to].y));
    }
    return end - y;
}

/* Begins at the top, and moves on to row y, if that is below. */
static void start(struct pel_smooth_walk *k, int i, int32_t top, int32_t y)
{
    struct pel_smooth_side *const s = &k->side[i];
    s->to = top;
    while (pel_smooth_next_edge(k, s) && k->v[s->to].y <= PEL_PX(y))
        ;
    const int32_t above = k->v[s->from].y;
    if (s->from == s->to || above >= PEL_PX(y))
        return;
    const int32_t first = (above + 255) >> 8;
    s->at += pel_smooth_part(s->step, PEL_PX(first) - above) +
             (int64_t)pel_times((uint64_t)s->step, y - first);
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

/* The box of n vertices, in sub-pixels. */
static struct pel_rect box_of(const struct pel_point *v, int32_t n)
{
    struct pel_rect r = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    for (; n > 0; n--, v++) {
        r.x0 = pel_min(r.x0, v->x);
        r.y0 = pel_min(r.y0, v->y);
        r.x1 = pel_max(r.x1, v->x);
        r.y1 = pel_max(r.y1, v->y);
    }
    return r;
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

static void walk_rows(struct pel_smooth_walk *k, int32_t y, int32_t end)
{
    while (y < end) {
        const int32_t rows = rows_across(k, y, end);
        if (rows <= 0) {
            pel_smooth_vertex_row(k, y++);
            continue;
        }
        pel_smooth_cross_rows(k, y, rows);
        y += rows;
        for (int i = 0; i < 2; i++)
            if (k->v[k->side[i].to].y <= PEL_PX(y))
                pel_smooth_next_edge(k, &k->side[i]);
    }
}

void pel_smooth_convex(const struct pel_surface *surface,
                       const struct pel_point *v, int32_t n,
                       const struct pel_paint *paint)
{
    const struct pel_rect *const clip = &surface->clip;
    struct pel_smooth_walk k = {.v = v, .n = n};
    int32_t top = 0;
    const bool legal = pel_points_legal(v, n);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels(v, n, 0));
    if (!legal || !pel_smooth_begin(&k.smooth, surface, paint))
        return;
    const struct pel_rect box = box_of(v, n);
    const int64_t area = area_of(v, n);
    const int32_t y = pel_max(pel_pixel_of(box.y0), clip->y0);
    const int32_t end = pel_min(pel_pixel_of(box.y1 + 255), clip->y1);
    if (area == 0 || y >= end || is_beside(&box, clip))
        return;
    while (v[top].y != box.y0)
        top++;
    k.inside = is_inside(&box, clip);
    k.bottom = box.y1;
    k.side[0].turn = area > 0 ? -1 : 1;
    k.side[1].turn = -k.side[0].turn;
    start(&k, 0, top, y);
    start(&k, 1, top, y);
    walk_rows(&k, y, end);
}

void pel_smooth_triangle(const struct pel_surface *surface,
                         const struct pel_point v[3],
                         const struct pel_paint *paint)
{
    pel_smooth_convex(surface, v, 3, paint);
}
