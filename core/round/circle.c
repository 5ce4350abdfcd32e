#include "circle.h"

/* One side of the disc, right or left of its centre, as a walk over columns.
 * u is the distance of the next column outwards, whose centre is not yet in the
 * run, and that column joins when d = floor((radius^2 - v^2 - u^2) / 512) >= 0,
 * v the distance of the line. Steps of u and v by 256 change the numerator by
 * multiples of 512, (u + 256)^2 - u^2 = 512 (u + 128), so the bits that the
 * floor drops never change, and the walk adds and never multiplies: Bresenham's
 * scheme. |d| < 2^43: u and v are at most 2^25. */
struct side {
    int64_t d;
    int32_t u;
    int32_t columns, limit; /* in the run now; those that the clip shows */
};

static PEL_NOINLINE void side_start(struct side *s, int64_t reach, int32_t u)
{
    s->d = (reach - (int64_t)u * u) >> 9;
    s->u = u;
    s->columns = 0;
}

/* The columns of the next row, and on to the row after it. */
static PEL_HOT int32_t side_next(struct side *s, int32_t v)
{
    while (s->d >= 0 && s->columns < s->limit) {
        s->d -= s->u + 128;
        s->u += 256;
        s->columns++;
    }
    while (s->columns > 0 && s->d + s->u - 128 < 0) {
        s->u -= 256;
        s->d += s->u + 128;
        s->columns--;
    }
    s->d -= v + 128;
    return s->columns;
}

void pel_circle(const struct pel_surface *surface, struct pel_point center,
                int32_t radius, const struct pel_paint *paint)
{
    bool legal =
        pel_point_legal(center) && radius >= 0 && radius <= PEL_PX(32767);
    PEL_ASSERT(legal);
    if (!legal || pel_rect_empty(&surface->clip))
        return;
    const struct pel_rect *clip = &surface->clip;
    struct pel_row row[PEL_BATCH_ROWS];
    struct pel_rows rows = {surface, row, 0, 0, 1};
    struct side left, right;
    rows.y = pel_max(pel_first_pixel(center.y - radius), clip->y0);
    int32_t end = pel_min(pel_pixel_of(center.y + radius + 128), clip->y1);
    int32_t v = pel_pixel_center(rows.y) - center.y;
    int64_t reach = (int64_t)radius * radius - (int64_t)v * v;
    int32_t split =
        pel_min(pel_max(pel_first_pixel(center.x), clip->x0), clip->x1);
    left.limit = split - clip->x0;
    right.limit = clip->x1 - split;
    side_start(&right, reach, pel_pixel_center(split) - center.x);
    side_start(&left, reach, center.x - pel_pixel_center(split - 1));
    for (; rows.y < end; rows.y += rows.n) {
        rows.n = pel_min(end - rows.y, PEL_BATCH_ROWS);
        for (int32_t i = 0; i < rows.n; i++, v += 256) {
            row[i].x0 = split - side_next(&left, v);
            row[i].x1 = split + side_next(&right, v);
        }
        paint->fill(paint, &rows);
    }
}
