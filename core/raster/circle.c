#include "circle.h"

#include "collect.h"

/* One side of the disc, right or left of its centre, as a walk over columns.
 * u is the distance of the next column outwards, whose centre is not yet in the
 * run, d = radius^2 - v^2 - u^2 with v the distance of the line. The column
 * joins when d >= 0. Incremented by Bresenham's scheme: no multiplication in
 * the walk. |d| < 2^51: u and v are at most 2^25. */
struct side {
    int64_t d;
    int32_t u;
    int32_t columns, limit; /* in the run now; never more than limit */
};

/* A walk that starts with the column at distance u and may take `limit` of
 * them: those the clip shows, so that its work is bounded by them. */
static struct side side_start(int64_t d, int32_t u, int32_t limit)
{
    struct side s = {d - (int64_t)u * u, u, 0, pel_max(limit, 0)};
    return s;
}

/* (u + 256)^2 - u^2 = 512 u + 65,536. */
static int64_t square_step(int32_t u)
{
    return (int64_t)u * 512 + 65536;
}

/* Adds or takes columns until the run is that of the present line. */
static void side_settle(struct side *s)
{
    while (s->d >= 0 && s->columns < s->limit) {
        s->d -= square_step(s->u);
        s->u += 256;
        s->columns++;
    }
    while (s->columns > 0 && s->d + square_step(s->u - 256) < 0) {
        s->u -= 256;
        s->d += square_step(s->u);
        s->columns--;
    }
}

/* The clipped disc between lines y and end. Right of the column `split`, the
 * first whose centre is at or right of the disc's, columns go right from
 * `first`, the first of them that the clip shows; left of it they go left from
 * `last`. When the clip lies on one side only, the other has no columns. */
static void fill_disc(struct pel_collector *c, struct pel_point center,
                      int32_t radius, int32_t y, int32_t end)
{
    const struct pel_rect *clip = &c->rows.surface->clip;
    const int32_t split = pel_first_pixel(center.x);
    const int32_t first = pel_max(split, clip->x0);
    const int32_t last = pel_min(split, clip->x1) - 1;
    int32_t v = pel_pixel_center(y) - center.y;
    int64_t d = (int64_t)radius * radius - (int64_t)v * v;
    struct side right =
        side_start(d, pel_pixel_center(first) - center.x, clip->x1 - first);
    struct side left =
        side_start(d, center.x - pel_pixel_center(last), last + 1 - clip->x0);
    for (; y < end; y++, v += 256) {
        side_settle(&right);
        side_settle(&left);
        int32_t x0 = left.limit ? last + 1 - left.columns : first;
        int32_t x1 = right.limit ? first + right.columns : last + 1;
        if (x0 < x1)
            pel_collect(c, y, x0, x1);
        right.d -= square_step(v);
        left.d -= square_step(v);
    }
}

void pel_circle(const struct pel_surface *surface, struct pel_point center,
                int32_t radius, const struct pel_paint *paint)
{
    bool legal =
        pel_points_legal(&center, 1) && radius >= 0 && radius <= PEL_PX(32767);
    PEL_ASSERT(legal);
    if (!legal || pel_rect_empty(&surface->clip))
        return;
    struct pel_collector c;
    pel_collect_begin(&c, surface, paint);
    int32_t y = pel_max(pel_first_pixel(center.y - radius), surface->clip.y0);
    int32_t end =
        pel_min(pel_pixel_of(center.y + radius + 128), surface->clip.y1);
    fill_disc(&c, center, radius, y, end);
    pel_collect_end(&c);
}
