/* A line with round ends: a half of a circle, a line, another half and a line
 * back. */
#include "../base/sqrt.h"
#include "line_side.h"
#include "smooth_thick_line.h"

struct capsule {
    struct pel_smooth_lines lines; /* first */
    struct pel_smooth_curve curve[2];
    struct pel_smooth_ends ends[2];
    struct pel_smooth_line line[2];
};

/* The place at a radius across a direction, which is not 0; right of it on
 * screen where it goes down. The inverse of its length is 2^(62 - shift) times
 * that: 2^30 are a whole. */
static struct pel_smooth_place place_across(struct pel_point d, int32_t radius)
{
    int shift;
    const uint64_t square = (uint64_t)(pel_square(d.x) + pel_square(d.y));
    const uint32_t inverse = pel_inverse_root(square, &shift);
    const int64_t x = (int64_t)pel_times(inverse, d.y) >> (32 - shift);
    const int64_t y = (int64_t)pel_times(inverse, -d.x) >> (32 - shift);
    return (struct pel_smooth_place){(int32_t)(x * radius >> 22),
                                     (int32_t)(y * radius >> 22)};
}

/* Of a direction; 0 begins at +x. */
static uint8_t quadrant_of(struct pel_smooth_place d)
{
    if (d.x > 0 && d.y >= 0)
        return 0;
    if (d.x <= 0 && d.y > 0)
        return 1;
    return d.x < 0 ? 2 : 3;
}

/* The half of a circle from a place on clockwise. */
static PEL_NOINLINE_32 void set_half(struct capsule *c, int32_t i,
                                     struct pel_smooth_place from,
                                     int32_t radius)
{
    struct pel_smooth_curve *const curve = &c->curve[i];
    c->ends[i].from = from;
    c->ends[i].to.x = -from.x;
    c->ends[i].to.y = -from.y;
    pel_smooth_circle_set(&curve->circle, radius);
    curve->circle.first = quadrant_of(from);
    curve->circle.count = 3;
}

/* From the upper end to the lower one, or from the left to the right; without
 * length, to the right. */
static PEL_NOINLINE void set_capsule(struct capsule *c,
                                     const struct pel_thick_line_shape *line)
{
    const int32_t radius = line->width >> 1;
    const bool turn = line->from.y > line->to.y ||
                      (line->from.y == line->to.y && line->from.x > line->to.x);
    const struct pel_point a = turn ? line->to : line->from;
    const struct pel_point b = turn ? line->from : line->to;
    struct pel_point d = {b.x - a.x, b.y - a.y};
    d.x += d.x == 0 && d.y == 0;
    const struct pel_smooth_place right = place_across(d, radius);
    const struct pel_smooth_place left = {-right.x, -right.y};
    pel_smooth_lines_begin(&c->lines, c->curve, c->ends, c->line,
                           pel_magnitude(d.x) > PEL_PX(32767));
    c->curve[0].center = a;
    c->curve[1].center = b;
    set_half(c, 0, left, radius);
    set_half(c, 1, right, radius);
    pel_smooth_lines_add(&c->lines, d, 0);
    pel_smooth_lines_add(&c->lines, d, 1);
}

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(const struct pel_surface *surface,
                                  struct capsule *c,
                                  const struct pel_thick_line_shape *line,
                                  const struct pel_paint *paint)
{
    const bool legal = pel_thick_line_legal(line);
    PEL_ASSERT(legal);
    PEL_HINT(pel_thick_line_in_subpixels(line));
    if (!legal || line->width <= 1)
        return false;
    const struct pel_rect box = pel_thick_line_box(line);
    const struct pel_rect pixels = {pel_pixel_of(box.x0), pel_pixel_of(box.y0),
                                    pel_pixel_of(box.x1) + 1,
                                    pel_pixel_of(box.y1) + 1};
    set_capsule(c, line);
    return pel_smooth_outline_begin(&c->lines.outline, surface, &pixels, paint);
}

void pel_smooth_thick_line_round(const struct pel_surface *surface,
                                 const struct pel_thick_line_shape *line,
                                 const struct pel_paint *paint)
{
    struct capsule c;
    if (begin(surface, &c, line, paint))
        pel_smooth_outline_paint(&c.lines.outline);
}
