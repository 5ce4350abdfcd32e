#include "round_area.h"

#include "core/base/trig.h"

static void cut_to(struct area_polygon *p, real x0, real y0, real x1, real y1)
{
    area_cut(p, -1, 0, -x0);
    area_cut(p, 0, -1, -y0);
    area_cut(p, 1, 0, x1);
    area_cut(p, 0, 1, y1);
}

/* The rectangle, less its corners' squares, and quarters of a disc there. */
static real rounded_at(const struct round *s, int32_t x, int32_t y)
{
    const int32_t width = s->to.x - s->center.x, height = s->to.y - s->center.y;
    const int32_t least = pel_min(width, height) / 2;
    const int32_t radius = pel_min(s->radius, least);
    const real r = (real)radius / 256;
    struct area_polygon p =
        area_pixel((real)s->center.x, (real)s->center.y, x, y);
    cut_to(&p, 0, 0, (real)width / 256, (real)height / 256);
    real area = area_of_polygon(&p);
    for (int i = 0; i < 4 && radius > 0; i++) {
        const real cx = (real)(i % 2 ? s->center.x + radius : s->to.x - radius);
        const real cy = (real)(i / 2 ? s->center.y + radius : s->to.y - radius);
        p = area_pixel(cx, cy, x, y);
        cut_to(&p, i % 2 ? -r : 0, i / 2 ? -r : 0, i % 2 ? 0 : r,
               i / 2 ? 0 : r);
        area -= area_of_polygon(&p) - area_in_disc(&p, r);
    }
    return area;
}

/* Keeps what is clockwise of a ray, up to half a turn: sign 1; or before it. */
static void cut_ray(struct area_polygon *p, struct pel_point d, int sign)
{
    area_cut(p, sign * (real)d.y, -sign * (real)d.x, 0);
}

/* The part of a ring in an angle of at most half a turn. */
static real wedge_at(const struct round *s, int32_t from, int32_t turn,
                     struct area_polygon p)
{
    cut_ray(&p, pel_direction((uint16_t)from), 1);
    cut_ray(&p, pel_direction((uint16_t)(from + turn)), -1);
    const real hole = s->kind == SECTOR ? 0 : (real)s->inner / 256;
    return area_in_disc(&p, (real)s->radius / 256) -
           (hole > 0 ? area_in_disc(&p, hole) : 0);
}

bool round_between_places(const struct round *s, int32_t angle)
{
    const struct pel_point d = pel_direction((uint16_t)angle);
    const real length = real_root((real)d.x * d.x + (real)d.y * d.y);
    const real middle = (real)((s->inner + s->radius) / 2) / length;
    const real u = d.x * middle, v = d.y * middle;
    return real_abs(u - real_floor(u) - 0.5L) < 0.02L ||
           real_abs(v - real_floor(v) - 0.5L) < 0.02L;
}

/* What a disc at the end of an arc adds beyond its ray: sign 1 at the end. */
static real end_at(const struct round *s, int32_t angle, int sign, int32_t x,
                   int32_t y)
{
    const struct pel_point d = pel_direction((uint16_t)angle);
    const real dx = d.x, dy = d.y, length = real_root(dx * dx + dy * dy);
    const int32_t middle = (s->inner + s->radius) / 2;
    const real u = real_round(dx * middle / length);
    const real v = real_round(dy * middle / length);
    struct area_polygon p = area_pixel(s->center.x + u, s->center.y + v, x, y);
    area_cut(&p, sign * dy, -sign * dx, -sign * (dy * u - dx * v) / 256);
    return area_in_disc(&p, (real)((s->radius - s->inner) / 2) / 256);
}

static real arc_at(const struct round *s, int32_t x, int32_t y)
{
    const struct area_polygon pixel =
        area_pixel((real)s->center.x, (real)s->center.y, x, y);
    const int32_t half = s->turn / 2;
    if (s->turn <= 0 || (s->kind != SECTOR && s->inner >= s->radius))
        return 0;
    real area = wedge_at(s, s->from, half, pixel) +
                wedge_at(s, s->from + half, s->turn - half, pixel);
    if (s->kind == ARC_ROUND)
        area += end_at(s, s->from, -1, x, y) +
                end_at(s, s->from + s->turn, 1, x, y);
    return area;
}

/* A rectangle, and two half discs beyond it. */
static real line_at(const struct round *s, int32_t x, int32_t y)
{
    real dx = (real)s->to.x - s->center.x, dy = (real)s->to.y - s->center.y;
    const real radius = (real)(s->radius / 2) / 256;
    const real length = real_root(dx * dx + dy * dy);
    struct area_polygon p =
        area_pixel((real)s->center.x, (real)s->center.y, x, y);
    if (length == 0)
        return area_in_disc(&p, radius);
    dx /= length;
    dy /= length;
    area_cut(&p, dx, dy, 0);
    real area = area_in_disc(&p, radius);
    p = area_pixel((real)s->to.x, (real)s->to.y, x, y);
    area_cut(&p, -dx, -dy, 0);
    area += area_in_disc(&p, radius);
    p = area_pixel((real)s->center.x, (real)s->center.y, x, y);
    area_cut(&p, -dx, -dy, 0);
    area_cut(&p, dx, dy, length / 256);
    area_cut(&p, -dy, dx, radius);
    area_cut(&p, dy, -dx, radius);
    return area + area_of_polygon(&p);
}

/* x is scaled so that it is a disc. */
static real ellipse_at(const struct round *s, struct area_polygon p)
{
    if (s->radius == 0 || s->inner == 0)
        return 0;
    const real scale = (real)s->inner / s->radius;
    for (int i = 0; i < p.n; i++)
        p.v[i].x *= scale;
    return area_in_disc(&p, (real)s->inner / 256) / scale;
}

real round_area_at(const struct round *s, int32_t x, int32_t y)
{
    const struct area_polygon pixel =
        area_pixel((real)s->center.x, (real)s->center.y, x, y);
    if (s->kind == DISC)
        return area_in_disc(&pixel, (real)s->radius / 256);
    if (s->kind == ELLIPSE)
        return ellipse_at(s, pixel);
    if (s->kind == ROUNDED)
        return rounded_at(s, x, y);
    if (s->kind == LINE)
        return line_at(s, x, y);
    if (s->kind != RING)
        return arc_at(s, x, y);
    return s->inner < s->radius ? area_in_disc(&pixel, (real)s->radius / 256) -
                                      area_in_disc(&pixel, (real)s->inner / 256)
                                : 0;
}
