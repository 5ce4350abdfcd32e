#include "smooth_thick_line.h"

#include "short_walk.h"

static PEL_NOINLINE_32 bool corners_of(const struct pel_thick_line_shape *line,
                                       bool square, struct pel_point v[4])
{
    if (!pel_thick_line_corners(line, v))
        return false;
    /* n is half of the width across, (n.y, -n.x) along the line */
    const int32_t x = square ? v[0].y - line->from.y : 0;
    const int32_t y = square ? line->from.x - v[0].x : 0;
    for (int i = 0; i < 4; i++) {
        const bool end = i == 1 || i == 2;
        v[i].x += end ? x : -x;
        v[i].y += end ? y : -y;
    }
    return pel_points_legal(v, 4);
}

/* Does a pixel of the clip touch its box, which is larger at square ends? */
static PEL_NOINLINE_32 bool is_seen(const struct pel_thick_line_shape *line,
                                    const struct pel_rect *clip)
{
    const struct pel_rect box = pel_thick_line_box(line);
    const int32_t end = line->width / 2;
    return pel_pixel_of(box.x0 - end) < clip->x1 &&
           pel_pixel_of(box.x1 + end) >= clip->x0 &&
           pel_pixel_of(box.y0 - end) < clip->y1 &&
           pel_pixel_of(box.y1 + end) >= clip->y0;
}

static bool set_corners(const struct pel_surface *surface,
                        const struct pel_thick_line_shape *line, bool square,
                        struct pel_point v[4])
{
    PEL_HINT(pel_thick_line_in_subpixels(line));
    if (pel_thick_line_legal(line) && !is_seen(line, &surface->clip))
        return false;
    const bool legal = corners_of(line, square, v);
    PEL_ASSERT(legal);
    return legal;
}

static PEL_NOINLINE bool begin_short(struct pel_smooth_short_walk *k,
                                     const struct pel_surface *surface)
{
    const struct pel_thick_line_shape *const line = k->shape.line;
    struct pel_point *const v = k->work.v;
    if (!set_corners(surface, line, k->square, v))
        return false;
    k->line = true;
    k->of.m = (struct pel_point){v[0].x - line->from.x, v[0].y - line->from.y};
    return pel_smooth_short_begin(k, surface, v, 4);
}

static PEL_ALWAYS_INLINE void paint_short(
    const struct pel_surface *surface, const struct pel_thick_line_shape *line,
    bool square, const struct pel_paint *paint)
{
    struct pel_smooth_short_walk k;
    k.shape.line = line;
    k.square = square;
    k.pixels.smooth.paint = paint;
    if (begin_short(&k, surface))
        pel_smooth_short_paint(&k);
}

static void paint_corners(const struct pel_surface *surface,
                          const struct pel_thick_line_shape *line, bool square,
                          const struct pel_paint *paint)
{
    struct pel_point v[4];
    if (set_corners(surface, line, square, v))
        pel_smooth_convex(surface, v, 4, paint);
}

static PEL_ALWAYS_INLINE void paint_line(
    const struct pel_surface *surface, const struct pel_thick_line_shape *line,
    bool square, const struct pel_paint *paint)
{
    if (PEL_SMOOTH_TINY)
        paint_short(surface, line, square, paint);
    else
        paint_corners(surface, line, square, paint);
}

void pel_smooth_thick_line(const struct pel_surface *surface,
                           const struct pel_thick_line_shape *line,
                           const struct pel_paint *paint)
{
    paint_line(surface, line, false, paint);
}

void pel_smooth_thick_line_square(const struct pel_surface *surface,
                                  const struct pel_thick_line_shape *line,
                                  const struct pel_paint *paint)
{
    paint_line(surface, line, true, paint);
}
