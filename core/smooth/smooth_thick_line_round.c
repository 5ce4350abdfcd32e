/* A line with round ends: two sides, each of which is an arc around the upper
 * end, a line and an arc around the lower one. Rows that both sides cross as
 * lines are those of a convex polygon (smooth_walk.h). */
#include "../base/sqrt.h"
#include "outline.h"
#include "smooth_thick_line.h"
#include "smooth_walk.h"

/* Pixels that a side of the body may cross in a row, in every build, since the
 * rows of arcs round other sums. */
enum { NARROW = 6 };

typedef char
    pel_smooth_narrow_fits[NARROW <= PEL_SMOOTH_BATCH_BYTES / 2 - 2 ? 1 : -1];

struct capsule {
    struct pel_point end[2], d; /* upper, lower; from one to the other */
    int32_t radius;
    struct pel_smooth_place across; /* from an end to the right side */
    struct pel_rise rise;
    int64_t step;         /* px 2^-32 to the next row, unless it is level */
    struct pel_rect box;  /* px */
    struct pel_span body; /* rows that both sides cross as lines */
};

/* r to the right of a direction down, which is not 0. The inverse of its length
 * is 2^(62 - shift) times that: 2^30 are a whole. */
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

/* Of the place from an end to a side. */
static struct pel_smooth_place side_of(const struct capsule *c, bool left)
{
    const struct pel_smooth_place p = {left ? -c->across.x : c->across.x,
                                       left ? -c->across.y : c->across.y};
    return p;
}

/* Where a side begins, or ends, as a line: 2^-16 px below the upper end. */
static int64_t side_top(const struct capsule *c, bool left)
{
    return side_of(c, left).y;
}

static int64_t side_bottom(const struct capsule *c, bool left)
{
    return (int64_t)c->d.y * 256 + side_of(c, left).y;
}

/* x there, from the upper end. What the side moves is below 2^32, of which an
 * error of the step is less than a unit. */
static int64_t side_at(const struct capsule *c, bool left, int64_t v)
{
    const struct pel_smooth_place p = side_of(c, left);
    const uint64_t step = (uint64_t)pel_size_of(c->step);
    const uint32_t down = (uint32_t)(v - p.y);
    const int64_t way = (int64_t)(pel_multiply((uint32_t)(step >> 32), down) +
                                  (pel_multiply((uint32_t)step, down) >> 32));
    return p.x + (c->step < 0 ? -way : way);
}

/* The top of a row, 2^-16 px below the upper end. */
static int64_t row_top(const struct capsule *c, int32_t y)
{
    return ((int64_t)y * 256 - c->end[0].y) * 256;
}

/* The line's part of a side in a row; false: none. */
static bool find_piece(const struct capsule *c, bool left, int32_t y,
                       struct pel_smooth_line_piece *piece)
{
    const int64_t top = side_top(c, left), bottom = side_bottom(c, left);
    int64_t from = row_top(c, y), to = from + 65536;
    from = from > top ? from : top;
    to = to < bottom ? to : bottom;
    if (from >= to)
        return false;
    const int64_t a = side_at(c, left, from), b = side_at(c, left, to);
    pel_smooth_line_piece_set(piece, c->end[0].x, a, b);
    piece->h = (int32_t)(to - from);
    piece->rise = c->rise;
    return true;
}

/* Rows with arcs in them. */
struct caps {
    struct pel_smooth smooth;
    struct pel_smooth_bow bow[2];
};

/* The pieces of lines in a row. */
struct sides {
    struct pel_smooth_line_piece piece[2];
    bool crossed[2];
};

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
static struct pel_smooth_bow half_of(struct pel_point center,
                                     struct pel_smooth_place from)
{
    return (struct pel_smooth_bow){.center = center,
                                   .from = from,
                                   .to = {-from.x, -from.y},
                                   .first = quadrant_of(from),
                                   .count = 3};
}

static PEL_NOINLINE int32_t paint_window(struct caps *caps,
                                         const struct sides *sides, int32_t y,
                                         int32_t x, int32_t end)
{
    struct pel_smooth_window w;
    pel_smooth_window_begin(&w, y, x, end);
    for (int i = 0; i < 2; i++) {
        pel_smooth_bow_add(&caps->bow[i], &w);
        if (sides->crossed[i])
            pel_smooth_window_line(&w, &sides->piece[i], i == 0);
    }
    pel_smooth_window_paint(&w, &caps->smooth);
    return w.next;
}

static void paint_cap_row(struct caps *caps, const struct capsule *c, int32_t y)
{
    const struct pel_rect *const clip = &caps->smooth.target->clip;
    const int32_t end = pel_min(c->box.x1, clip->x1);
    struct sides sides;
    int32_t x = pel_max(c->box.x0, clip->x0);
    for (int i = 0; i < 2; i++)
        sides.crossed[i] = find_piece(c, i == 0, y, &sides.piece[i]);
    while (x < end)
        x = paint_window(caps, &sides, y, x, end);
}

static PEL_NOINLINE void paint_caps(const struct pel_surface *surface,
                                    const struct capsule *c, int32_t y,
                                    int32_t end, const struct pel_paint *paint)
{
    struct caps caps;
    if (y >= end || !pel_smooth_begin(&caps.smooth, surface, paint))
        return;
    caps.bow[0] = half_of(c->end[0], side_of(c, true));
    caps.bow[1] = half_of(c->end[1], side_of(c, false));
    pel_smooth_bow_set(&caps.bow[0], c->radius);
    pel_smooth_bow_set(&caps.bow[1], c->radius);
    for (; y < end; y++)
        paint_cap_row(&caps, c, y);
}

/* A row's top of a side, px 2^-32: floored at the first one of the body to
 * 2^-16 px. */
static void start_side(struct pel_smooth_side *side, const struct capsule *c,
                       bool left, int32_t y)
{
    const int32_t first = c->body.x0;
    const int64_t x =
        (int64_t)c->end[0].x * 256 + side_at(c, left, row_top(c, first));
    side->step = c->step;
    side->at = x * 65536 + (int64_t)pel_times((uint64_t)c->step, y - first);
    side->rise = c->rise;
}

static PEL_NOINLINE void paint_body(const struct pel_surface *surface,
                                    const struct capsule *c,
                                    const struct pel_paint *paint)
{
    const struct pel_rect *const clip = &surface->clip;
    const int32_t y = pel_max(c->body.x0, clip->y0);
    const int32_t end = pel_min(c->body.x1, clip->y1);
    struct pel_smooth_walk walk;
    if (y >= end || !pel_smooth_begin(&walk.smooth, surface, paint))
        return;
    walk.inside = c->box.x0 >= clip->x0 && c->box.x1 <= clip->x1;
    start_side(&walk.side[0], c, true, y);
    start_side(&walk.side[1], c, false, y);
    pel_smooth_cross_rows(&walk, y, end - y);
}

/* None where a side crosses many pixels in a row. */
static void find_body(struct capsule *c)
{
    const int32_t tip = pel_magnitude(c->across.y);
    const int32_t a = c->end[0].y + ((tip + 255) >> 8);
    const int32_t b = c->end[1].y - ((tip + 255) >> 8);
    c->body = (struct pel_span){pel_pixel_of(a + 255), pel_pixel_of(b)};
    if (c->body.x0 >= c->body.x1 || pel_magnitude(c->d.x) >= NARROW * c->d.y)
        c->body.x0 = c->body.x1 = c->box.y1;
}

/* From the upper end to the lower one, or from the left to the right. */
static void set_ends(struct capsule *c, const struct pel_thick_line_shape *line)
{
    const bool turn = line->from.y > line->to.y ||
                      (line->from.y == line->to.y && line->from.x > line->to.x);
    const struct pel_point a = turn ? line->to : line->from;
    const struct pel_point b = turn ? line->from : line->to;
    c->end[0] = a;
    c->end[1] = b;
    c->d = (struct pel_point){b.x - a.x, b.y - a.y};
    c->d.x += c->d.x == 0 && c->d.y == 0;
}

static PEL_NOINLINE void set_capsule(struct capsule *c,
                                     const struct pel_thick_line_shape *line)
{
    const struct pel_rect box = pel_thick_line_box(line);
    c->box =
        (struct pel_rect){pel_pixel_of(box.x0), pel_pixel_of(box.y0),
                          pel_pixel_of(box.x1) + 1, pel_pixel_of(box.y1) + 1};
    set_ends(c, line);
    c->radius = line->width >> 1;
    c->across = place_across(c->d, c->radius);
    c->step = pel_smooth_slope(&c->end[0], &c->end[1], &c->rise);
    find_body(c);
}

void pel_smooth_thick_line_round(const struct pel_surface *surface,
                                 const struct pel_thick_line_shape *line,
                                 const struct pel_paint *paint)
{
    const struct pel_rect *const clip = &surface->clip;
    struct capsule c;
    const bool legal = pel_thick_line_legal(line);
    PEL_ASSERT(legal);
    PEL_HINT(pel_thick_line_in_subpixels(line));
    if (!legal || line->width <= 1)
        return;
    set_capsule(&c, line);
    const struct pel_rect seen = pel_rect_intersect(&c.box, clip);
    if (pel_rect_empty(&seen))
        return;
    paint_caps(surface, &c, seen.y0, pel_min(c.body.x0, seen.y1), paint);
    paint_body(surface, &c, paint);
    paint_caps(surface, &c, pel_max(c.body.x1, seen.y0), seen.y1, paint);
}
