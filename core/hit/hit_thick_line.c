#include "hit.h"

#include "hit_pixel.h"

/* Sub-pixels; more than rounding moves a corner (thick_line.h). */
enum { MARGIN = 2 };

enum place { OUTSIDE, INSIDE, AT_EDGE };

static int32_t magnitude(int32_t v)
{
    return v < 0 ? -v : v;
}

static bool in_box(struct pel_point p, struct pel_point a, struct pel_point b,
                   int32_t margin)
{
    return p.x >= pel_min(a.x, b.x) - margin &&
           p.x <= pel_max(a.x, b.x) + margin &&
           p.y >= pel_min(a.y, b.y) - margin &&
           p.y <= pel_max(a.y, b.y) + margin;
}

/* Decides without the length of the line, which lies between the larger of |dx|
 * and |dy| and their sum. cross and dot are the distances of p from the line
 * and along it, times the length. */
static enum place place_of(const struct pel_thick_line_shape *line,
                           struct pel_point p)
{
    const struct pel_point a = line->from, b = line->to;
    const int32_t dx = b.x - a.x, dy = b.y - a.y;
    const int32_t u = p.x - a.x, v = p.y - a.y, half = line->width / 2;
    const int32_t most = magnitude(dx) + magnitude(dy);
    const int32_t least = pel_max(magnitude(dx), magnitude(dy));
    int64_t cross = pel_product(dx, v) - pel_product(dy, u);
    if (cross < 0)
        cross = -cross;
    if (cross > pel_product(half + MARGIN, most))
        return OUTSIDE;
    const int64_t dot = pel_product(dx, u) + pel_product(dy, v);
    const int64_t rest = pel_square(dx) + pel_square(dy) - dot;
    const int32_t end = MARGIN * most;
    if (dot < -end || rest < -end)
        return OUTSIDE;
    return dot > end && rest > end && half > MARGIN &&
                   cross < pel_product(half - MARGIN, least)
               ? INSIDE
               : AT_EDGE;
}

bool pel_hit_thick_line(const struct pel_thick_line_shape *line, int32_t x,
                        int32_t y)
{
    struct pel_point p, v[4];
    if (!pel_hit_pixel(x, y, &p) || !pel_point_legal(line->from) ||
        !pel_point_legal(line->to) || !pel_radius_legal(line->width) ||
        !in_box(p, line->from, line->to, line->width / 2 + MARGIN))
        return false;
    const enum place place = place_of(line, p);
    if (place == OUTSIDE)
        return false;
    /* A line with a corner out of range covers nothing. */
    const struct pel_point low = {PEL_COORDINATE_MIN, PEL_COORDINATE_MIN};
    const struct pel_point high = {PEL_COORDINATE_MAX, PEL_COORDINATE_MAX};
    const int32_t inner = -(line->width / 2 + MARGIN);
    if (place == INSIDE && in_box(line->from, low, high, inner) &&
        in_box(line->to, low, high, inner))
        return true;
    const struct pel_polygon_shape polygon = {v, 4, PEL_NON_ZERO};
    return pel_thick_line_corners(line, v) && pel_hit_polygon(&polygon, x, y);
}
