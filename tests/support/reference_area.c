#include "reference_area.h"

#define TWO_PI 6.283185307179586476925286766559005768L

struct area_polygon area_pixel(real center_x, real center_y, int32_t x,
                               int32_t y)
{
    const real u = x - center_x / 256, v = y - center_y / 256;
    return (struct area_polygon){
        4, {{u, v}, {u + 1, v}, {u + 1, v + 1}, {u, v + 1}}};
}

void area_cut(struct area_polygon *p, real a, real b, real c)
{
    const struct area_polygon from = *p;
    p->n = 0;
    for (int i = 0; i < from.n; i++) {
        const int k = (i + 1) % from.n;
        const real s = a * from.v[i].x + b * from.v[i].y - c;
        const real t = a * from.v[k].x + b * from.v[k].y - c;
        if (s <= 0)
            p->v[p->n++] = from.v[i];
        if ((s < 0 && t > 0) || (s > 0 && t < 0)) {
            const real f = s / (s - t);
            p->v[p->n].x = from.v[i].x + (from.v[k].x - from.v[i].x) * f;
            p->v[p->n++].y = from.v[i].y + (from.v[k].y - from.v[i].y) * f;
        }
    }
}

real area_of_polygon(const struct area_polygon *p)
{
    real area = 0;
    for (int i = 0; i < p->n; i++) {
        const int k = (i + 1) % p->n;
        area += (p->v[i].x - p->v[0].x) * (p->v[k].y - p->v[0].y) -
                (p->v[k].x - p->v[0].x) * (p->v[i].y - p->v[0].y);
    }
    return area / 2;
}

/* Between the rays to two points less than half a turn apart. */
static real sector(real ax, real ay, real bx, real by, real radius)
{
    real turn = real_turn(ax * bx + ay * by, ax * by - ay * bx);
    turn = turn > 0.5L ? turn - 1 : turn;
    return turn * (TWO_PI / 2) * radius * radius;
}

/* Of the triangle with (0, 0), with its sign: what is outside of the circle is
 * replaced by a sector. The line from a to b is inside between the parameters
 * `from` and `to`. */
static real triangle(real ax, real ay, real bx, real by, real radius)
{
    const real dx = bx - ax, dy = by - ay, length2 = dx * dx + dy * dy;
    if (length2 == 0)
        return 0;
    const real middle = -(ax * dx + ay * dy) / length2;
    const real cross = ax * by - ay * bx;
    const real half2 =
        radius * radius / length2 - cross * cross / (length2 * length2);
    if (half2 <= 0)
        return sector(ax, ay, bx, by, radius);
    real from = middle - real_root(half2), to = middle + real_root(half2);
    from = from < 0 ? 0 : from > 1 ? 1 : from;
    to = to < 0 ? 0 : to > 1 ? 1 : to;
    const real px = ax + dx * from, py = ay + dy * from;
    const real qx = ax + dx * to, qy = ay + dy * to;
    return (from > 0 ? sector(ax, ay, px, py, radius) : 0) +
           cross * (to - from) / 2 +
           (to < 1 ? sector(qx, qy, bx, by, radius) : 0);
}

/* From the first corner to the farthest. */
static real extent_of(const struct area_polygon *p)
{
    real most = 0;
    for (int i = 1; i < p->n; i++) {
        const real x = p->v[i].x - p->v[0].x, y = p->v[i].y - p->v[0].y;
        most = x * x + y * y > most ? x * x + y * y : most;
    }
    return real_root(most);
}

/* A polygon all inside or all outside needs no arcs. */
real area_in_disc(const struct area_polygon *p, real radius)
{
    real area = 0;
    const real extent = extent_of(p), x = p->v[0].x, y = p->v[0].y;
    const real distance = real_root(x * x + y * y);
    if (p->n == 0 || distance - extent > radius)
        return 0;
    if (distance + extent < radius)
        return area_of_polygon(p);
    for (int i = 0; i < p->n; i++) {
        const int k = (i + 1) % p->n;
        area += triangle(p->v[i].x, p->v[i].y, p->v[k].x, p->v[k].y, radius);
    }
    return area;
}
