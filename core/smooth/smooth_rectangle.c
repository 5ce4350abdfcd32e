#include "smooth_rectangle.h"

/* Pixels of a part of a row of the same coverage. */
enum { BYTES = PEL_64BIT ? 64 : PEL_SMALL_CODE ? 8 : 16 };

/* The part of pixel i that lies in [from, to), 1/256. */
static int32_t part_of(int32_t i, int32_t from, int32_t to)
{
    return pel_min(to - PEL_PX(i), 256) - pel_max(from - PEL_PX(i), 0);
}

static uint8_t coverage_of(uint32_t width, uint32_t height)
{
    return (uint8_t)((255 * width * height + 32768) >> 16);
}

/* The pixels that a box of sub-pixels touches. */
static struct pel_rect touched_by(const struct pel_rect *box)
{
    const struct pel_rect r = {pel_pixel_of(box->x0), pel_pixel_of(box->y0),
                               pel_pixel_of(box->x1 + 255),
                               pel_pixel_of(box->y1 + 255)};
    return r;
}

static void paint_row(struct pel_smooth *smooth, const struct pel_rect *box,
                      const struct pel_rect *px, int32_t y)
{
    const uint32_t h = (uint32_t)part_of(y, box->y0, box->y1);
    uint8_t bytes[BYTES];
    struct pel_smooth_row row = {y, px->x0, 0, 0, 0, bytes};
    while (row.x < px->x1) {
        for (row.left = 0; row.left < BYTES && row.x + row.left < px->x1;
             row.left++) {
            const uint32_t w =
                (uint32_t)part_of(row.x + row.left, box->x0, box->x1);
            bytes[row.left] = coverage_of(w, h);
            if (w * h == 65536)
                break;
        }
        row.full = 0;
        if (row.left < BYTES && row.x + row.left < px->x1)
            row.full =
                pel_min(px->x1, pel_pixel_of(box->x1)) - row.x - row.left;
        pel_smooth_paint(smooth, &row);
        row.x += row.left + row.full;
    }
}

void pel_smooth_rectangle(const struct pel_surface *surface,
                          struct pel_point from, struct pel_point to,
                          const struct pel_paint *paint)
{
    const struct pel_rect box = {from.x, from.y, to.x, to.y};
    const bool legal = pel_point_legal(from) && pel_point_legal(to);
    struct pel_smooth smooth;
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels((struct pel_point[2]){from, to}, 2, 0));
    if (!legal || !pel_smooth_begin(&smooth, surface, paint))
        return;
    const struct pel_rect touched = touched_by(&box);
    const struct pel_rect px = pel_rect_intersect(&touched, &surface->clip);
    if (from.x < to.x && from.y < to.y)
        for (int32_t y = px.y0; y < px.y1; y++)
            paint_row(&smooth, &box, &px, y);
}
