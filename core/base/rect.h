/* Rectangles of whole pixels, half-open: x0 <= x < x1, y0 <= y < y1. One with
 * x0 >= x1 or y0 >= y1 is empty. */
#ifndef PEL_BASE_RECT_H
#define PEL_BASE_RECT_H

#include "point.h"

struct pel_rect {
    int32_t x0, y0, x1, y1; /* px */
};

static inline bool pel_rect_empty(const struct pel_rect *r)
{
    return r->x0 >= r->x1 || r->y0 >= r->y1;
}

static inline struct pel_rect pel_rect_intersect(const struct pel_rect *a,
                                                 const struct pel_rect *b)
{
    const struct pel_rect r = {pel_max(a->x0, b->x0), pel_max(a->y0, b->y0),
                               pel_min(a->x1, b->x1), pel_min(a->y1, b->y1)};
    return r;
}

/* The box of a triangle, in sub-pixels. */
static inline struct pel_rect pel_corners_box(const struct pel_point v[3])
{
    const struct pel_rect r = {pel_min(pel_min(v[0].x, v[1].x), v[2].x),
                               pel_min(pel_min(v[0].y, v[1].y), v[2].y),
                               pel_max(pel_max(v[0].x, v[1].x), v[2].x),
                               pel_max(pel_max(v[0].y, v[1].y), v[2].y)};
    return r;
}

/* The box of two that are not empty. */
static inline struct pel_rect pel_rect_join(const struct pel_rect *a,
                                            const struct pel_rect *b)
{
    const struct pel_rect r = {pel_min(a->x0, b->x0), pel_min(a->y0, b->y0),
                               pel_max(a->x1, b->x1), pel_max(a->y1, b->y1)};
    return r;
}

/* The box of n >= 1 points. */
static inline struct pel_rect pel_points_box(const struct pel_point *v,
                                             int32_t n)
{
    struct pel_rect r = {v->x, v->y, v->x, v->y};
    while (--n > 0) {
        v++;
        const struct pel_rect point = {v->x, v->y, v->x, v->y};
        r = pel_rect_join(&r, &point);
    }
    return r;
}

/* The pixels inside `clip` whose centres lie in a box of sub-pixels. */
static inline struct pel_rect pel_rect_pixels(const struct pel_rect *box,
                                              const struct pel_rect *clip)
{
    const struct pel_rect r = {pel_max(pel_first_pixel(box->x0), clip->x0),
                               pel_max(pel_first_pixel(box->y0), clip->y0),
                               pel_min(pel_first_pixel(box->x1), clip->x1),
                               pel_min(pel_first_pixel(box->y1), clip->y1)};
    return r;
}

/* Those whose centres are at most a radius from a point, in each direction. */
static inline struct pel_rect pel_rect_around(struct pel_point center,
                                              struct pel_point radius,
                                              const struct pel_rect *clip)
{
    const struct pel_rect r = {
        pel_max(pel_first_pixel(center.x - radius.x), clip->x0),
        pel_max(pel_first_pixel(center.y - radius.y), clip->y0),
        pel_min(pel_pixel_of(center.x + radius.x + 128), clip->x1),
        pel_min(pel_pixel_of(center.y + radius.y + 128), clip->y1)};
    return r;
}

static inline bool pel_rect_inside(const struct pel_rect *r,
                                   const struct pel_rect *outer)
{
    return r->x0 >= outer->x0 && r->y0 >= outer->y0 && r->x1 <= outer->x1 &&
           r->y1 <= outer->y1;
}

#endif
