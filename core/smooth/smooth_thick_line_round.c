/* A line with round ends: a half of a circle, a line, another half and a line
 * back. */
#include "../base/sqrt.h"
#include "line_side.h"
#include "smooth_edge.h"
#include "smooth_thick_line.h"
#include "short_outline.h"

#include <stddef.h>

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
static void set_half(struct pel_smooth_curve *curve, struct pel_point center,
                     struct pel_smooth_place from)
{
    curve->center = center;
    curve->spread.x = curve->spread.y = 0;
    curve->circle.first = quadrant_of(from);
    curve->circle.count = 3;
}

/* From the upper end to the lower one, or from the left to the right. */
static void put_in_order(const struct pel_thick_line_shape *line,
                         struct pel_point end[2])
{
    const bool turn = line->from.y > line->to.y ||
                      (line->from.y == line->to.y && line->from.x > line->to.x);
    end[turn] = line->from;
    end[!turn] = line->to;
}

/* Without length, to the right. */
static struct pel_point direction_of(const struct pel_point end[2])
{
    struct pel_point d = {end[1].x - end[0].x, end[1].y - end[0].y};
    d.x += d.x == 0 && d.y == 0;
    return d;
}

static bool is_wide(const struct pel_thick_line_shape *line)
{
    return pel_magnitude(line->to.x - line->from.x) > PEL_PX(32767);
}

static bool is_legal(const struct pel_thick_line_shape *line)
{
    const bool legal = pel_thick_line_legal(line);
    PEL_ASSERT(legal);
    PEL_HINT(pel_thick_line_in_subpixels(line));
    return legal && line->width > 1;
}

static struct pel_rect box_of(const struct pel_thick_line_shape *line)
{
    const struct pel_rect box = pel_thick_line_box(line);
    return (struct pel_rect){pel_pixel_of(box.x0), pel_pixel_of(box.y0),
                             pel_pixel_of(box.x1) + 1,
                             pel_pixel_of(box.y1) + 1};
}

#if PEL_SMOOTH_TINY
struct capsule {
    struct pel_smooth_short_outline outline; /* first */
    const struct pel_thick_line_shape *line;
    struct pel_smooth_place right; /* the place across it */
    uint32_t inverse;              /* of its half circles */
    struct pel_smooth_slope slope;
    int64_t step; /* of its sides, to the next row: px 2^-32 */
};

static const struct capsule *capsule_of(
    const struct pel_smooth_short_outline *outline)
{
    return (const void *)outline;
}

/* Where curve i begins, or ends. */
static struct pel_smooth_place place_of(const struct capsule *c, int32_t i,
                                        bool last)
{
    const struct pel_smooth_place p = c->right, opposite = {-p.x, -p.y};
    return i == last ? opposite : p;
}

static bool curve_of(const struct pel_smooth_short_outline *outline, int32_t i,
                     struct pel_smooth_curve *curve)
{
    const struct capsule *const c = capsule_of(outline);
    struct pel_point end[2];
    put_in_order(c->line, end);
    pel_smooth_circle_begin(&curve->circle, c->line->width >> 1);
    curve->circle.of.inverse = c->inverse;
    set_half(curve, end[i], place_of(c, i, false));
    return true;
}

static bool cut(struct pel_smooth_short_outline *outline, int32_t i, int32_t k)
{
    struct pel_smooth_strip *const s = &outline->of.window.crossing.strip;
    const bool upright = (outline->of.window.curve.circle.first + k) & 1;
    const struct pel_smooth_place p = place_of(capsule_of(outline), i, k > 0);
    if (k != 1)
        pel_smooth_cut_at(s, &p, (k > 0) == upright);
    return pel_smooth_is_left(s);
}

/* The ends of side i. */
static PEL_NOINLINE void set_ends(const struct capsule *c, int32_t i,
                                  struct pel_smooth_far_place end[2])
{
    const struct pel_smooth_place p = place_of(c, i, true);
    struct pel_point at[2];
    put_in_order(c->line, at);
    for (int32_t k = 0; k < 2; k++) {
        end[k].x = (int64_t)at[k].x * 256 + p.x;
        end[k].y = (int64_t)at[k].y * 256 + p.y;
    }
}

/* A part of side i: all of it, or its upper or lower half. */
static PEL_ALWAYS_INLINE bool find_part(
    const struct pel_smooth_short_outline *outline, int32_t i, bool upper,
    bool lower, struct pel_smooth_crossing *crossing)
{
    const struct capsule *const c = capsule_of(outline);
    const int32_t y = outline->seen.y;
    struct pel_smooth_far_place end[2];
    set_ends(c, i, end);
    const int64_t middle = (end[0].y + end[1].y) >> 1;
    if (!pel_smooth_upright(crossing, y, upper ? end[0].y : middle,
                            lower ? end[1].y : middle))
        return false;
    const int64_t x = (end[0].x + end[1].x) >> 1;
    end[1].x = !lower && (middle - 1) >> 16 == y
                   ? x
                   : pel_smooth_line_at(end, &c->step, y, true);
    end[0].x = !upper && middle >> 16 == y
                   ? x
                   : pel_smooth_line_at(end, &c->step, y, false);
    pel_smooth_line_cross(crossing, end[0].x < end[1].x ? end[0].x : end[1].x,
                          (int32_t)(end[1].x - end[0].x));
    crossing->strip.slope = c->slope;
    crossing->rising = i > 0;
    return true;
}

static bool find_line(const struct pel_smooth_short_outline *outline, int32_t i,
                      struct pel_smooth_crossing *crossing)
{
    const bool wide = is_wide(capsule_of(outline)->line), lower = i & 1;
    return (wide || !lower) && find_part(outline, i >> 1, !wide || !lower,
                                         !wide || lower, crossing);
}

static const struct pel_smooth_kind sides = {2, 4, curve_of, cut, find_line};

static PEL_NOINLINE void set_capsule(struct capsule *c)
{
    const struct pel_point zero = {0, 0};
    struct pel_rise rise;
    struct pel_point end[2];
    put_in_order(c->line, end);
    const struct pel_point d = direction_of(end);
    c->inverse = pel_smooth_circle_inverse(c->line->width >> 1);
    c->right = place_across(d, c->line->width >> 1);
    c->step = pel_smooth_slope(&zero, &d, &rise);
    pel_smooth_slope_set(&c->slope, (uint64_t)pel_size_of(c->step));
}

/* False: nothing is to be seen. */
static PEL_NOINLINE bool begin(struct capsule *c)
{
    if (!is_legal(c->line))
        return false;
    const struct pel_rect box = box_of(c->line);
    return pel_smooth_short_outline_begin(&c->outline, &box);
}

void pel_smooth_thick_line_round(const struct pel_surface *surface,
                                 const struct pel_thick_line_shape *line,
                                 const struct pel_paint *paint)
{
    struct capsule c;
    c.outline.smooth = (struct pel_smooth){surface, paint};
    c.line = line;
    if (!begin(&c))
        return;
    set_capsule(&c);
    pel_smooth_short_outline_paint(&c.outline, &sides);
}
#else
struct capsule {
    struct pel_smooth_lines lines; /* first */
    struct pel_smooth_curve curve[2];
    struct pel_smooth_ends ends[2];
    struct pel_smooth_line line[2];
};

static PEL_NOINLINE void set_capsule(struct capsule *c,
                                     const struct pel_thick_line_shape *line)
{
    const int32_t radius = line->width >> 1;
    struct pel_point end[2];
    put_in_order(line, end);
    const struct pel_point d = direction_of(end);
    const struct pel_smooth_place right = place_across(d, radius);
    const struct pel_smooth_place left = {-right.x, -right.y};
    pel_smooth_lines_begin(&c->lines, c->curve, c->ends, c->line,
                           is_wide(line));
    for (int i = 0; i < 2; i++) {
        c->ends[i].from = i ? right : left;
        c->ends[i].to = i ? left : right;
        pel_smooth_circle_set(&c->curve[i].circle, radius);
        set_half(&c->curve[i], end[i], c->ends[i].from);
    }
    pel_smooth_lines_add(&c->lines, &d, 0);
    pel_smooth_lines_add(&c->lines, NULL, 1);
}

/* False: nothing is to be seen. */
static PEL_NOINLINE_32 bool begin(struct capsule *c,
                                  const struct pel_thick_line_shape *line)
{
    if (!is_legal(line))
        return false;
    const struct pel_rect box = box_of(line);
    set_capsule(c, line);
    return pel_smooth_outline_begin(&c->lines.outline, &box);
}

void pel_smooth_thick_line_round(const struct pel_surface *surface,
                                 const struct pel_thick_line_shape *line,
                                 const struct pel_paint *paint)
{
    struct capsule c;
    c.lines.outline.smooth = (struct pel_smooth){surface, paint};
    if (begin(&c, line))
        pel_smooth_outline_paint(&c.lines.outline);
}
#endif
