#include "../base/sqrt.h"
#include "path.h"
#include "smooth_thick_line.h"

/* The place at a radius to the right of a direction, which is not 0. The
 * inverse of its length is 2^(62 - shift) times that: 2^30 are a whole. */
static struct pel_smooth_path_place across(struct pel_point d, int32_t radius)
{
    int shift;
    const uint64_t square = (uint64_t)(pel_square(d.x) + pel_square(d.y));
    const uint32_t inverse = pel_inverse_root(square, &shift);
    const int64_t x = (int64_t)pel_times(inverse, -d.y) >> (32 - shift);
    const int64_t y = (int64_t)pel_times(inverse, d.x) >> (32 - shift);
    return (struct pel_smooth_path_place){(int32_t)(x * radius >> 22),
                                          (int32_t)(y * radius >> 22)};
}

/* Of a direction; 0 begins at +x. */
static int32_t quadrant_of(struct pel_point d)
{
    if (d.x > 0 && d.y >= 0)
        return 0;
    if (d.x <= 0 && d.y > 0)
        return 1;
    return d.x < 0 ? 2 : 3;
}

/* One side of the line in the direction d, at an offset to its left, and the
 * half disc at its end. */
static void add_half(struct pel_smooth_path *path,
                     const struct pel_point ends[2], struct pel_point d,
                     struct pel_smooth_path_place left, int32_t radius)
{
    const struct pel_smooth_way side = {ends[0], d, left};
    const struct pel_point outwards = {d.y, -d.x};
    const struct pel_smooth_path_arc bow = {.center = ends[1],
                                            .from = left,
                                            .to = {-left.x, -left.y},
                                            .first =
                                                (uint8_t)quadrant_of(outwards),
                                            .count = 3};
    pel_smooth_path_line(path, &side, (int64_t)ends[0].y * 256 + left.y,
                         (int64_t)ends[1].y * 256 + left.y);
    pel_smooth_path_bow(path, &bow, radius);
}

static void paint_line(struct pel_smooth_path *path,
                       const struct pel_thick_line_shape *line)
{
    const int32_t radius = line->width >> 1;
    const struct pel_rect box = pel_thick_line_box(line);
    const struct pel_rect pixels = {pel_pixel_of(box.x0), pel_pixel_of(box.y0),
                                    pel_pixel_of(box.x1) + 1,
                                    pel_pixel_of(box.y1) + 1};
    const struct pel_point ends[3] = {line->from, line->to, line->from};
    struct pel_point d = {line->to.x - line->from.x, line->to.y - line->from.y};
    d.x += d.x == 0 && d.y == 0;
    const struct pel_smooth_path_place right = across(d, radius);
    const struct pel_point back = {-d.x, -d.y};
    add_half(path, ends, d, (struct pel_smooth_path_place){-right.x, -right.y},
             radius);
    add_half(path, ends + 1, back, right, radius);
    pel_smooth_path_paint(path, &pixels);
}

void pel_smooth_thick_line_round(const struct pel_surface *surface,
                                 const struct pel_thick_line_shape *line,
                                 const struct pel_paint *paint)
{
    struct pel_smooth_path path;
    const bool legal = pel_thick_line_legal(line);
    PEL_ASSERT(legal);
    PEL_HINT(pel_thick_line_in_subpixels(line));
    if (legal && line->width > 1 &&
        pel_smooth_path_begin(&path, surface, paint))
        paint_line(&path, line);
}
