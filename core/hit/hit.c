#include "hit.h"

#include "../base/trig.h"
#include "../round/angle_range.h"

/* Sets *p to the centre of pixel (x, y); false when that is out of range. */
static inline bool set_point(int32_t x, int32_t y, struct pel_point *p)
{
    if ((((uint32_t)x + 32768u) | ((uint32_t)y + 32768u)) >> 16)
        return false;
    p->x = pel_pixel_center(x);
    p->y = pel_pixel_center(y);
    return true;
}

/* True in the closed disc; most pixels are outside of its square. */
static inline bool in_disc(struct pel_point p, struct pel_point center,
                           int32_t radius)
{
    const int32_t dx = p.x - center.x, dy = p.y - center.y;
    return dx <= radius && dx >= -radius && dy <= radius && dy >= -radius &&
           pel_square(dx) + pel_square(dy) <= pel_square(radius);
}

static bool may_hit(const struct pel_rect *box, int32_t x, int32_t y)
{
    if (x >= box->x0 && x < box->x1)
        return (y >= box->y0 && y < box->y1) || box->y0 >= box->y1;
    return pel_rect_empty(box);
}

int32_t pel_hit_topmost(const struct pel_target *const *targets, int32_t n,
                        int32_t x, int32_t y)
{
    if (n < 0)
        return -1;
    while (--n >= 0) {
        const struct pel_target *t = targets[n];
        if (may_hit(&t->box, x, y) && t->hit(t, x, y))
            break;
    }
    return n;
}

bool pel_hit_rectangle(struct pel_point from, struct pel_point to, int32_t x,
                       int32_t y)
{
    struct pel_point p;
    return set_point(x, y, &p) && pel_point_legal(from) &&
           pel_point_legal(to) && from.x <= p.x && p.x < to.x &&
           from.y <= p.y && p.y < to.y;
}

/* v moved by the least amount into lo..hi. */
static int32_t nearest(int32_t v, int32_t lo, int32_t hi)
{
    return pel_max(lo, pel_min(v, hi));
}

bool pel_hit_rounded_rectangle(const struct pel_rounded_shape *rectangle,
                               int32_t x, int32_t y)
{
    const struct pel_point from = rectangle->from, to = rectangle->to;
    struct pel_point p;
    if (!pel_hit_rectangle(from, to, x, y) || !set_point(x, y, &p) ||
        !pel_radius_legal(rectangle->radius))
        return false;
    int32_t half = pel_min(to.x - from.x, to.y - from.y) / 2;
    int32_t r = pel_min(rectangle->radius, half);
    const struct pel_point inner = {nearest(p.x, from.x + r, to.x - r),
                                    nearest(p.y, from.y + r, to.y - r)};
    return in_disc(p, inner, r);
}

/* The eighth of the turn, [k, k + 1) / 8, that holds the direction d. */
static int32_t eighth_of(struct pel_point d)
{
    int32_t eighth = 0;
    if (d.y < 0 || (d.y == 0 && d.x < 0)) {
        eighth = 4;
        d.x = -d.x;
        d.y = -d.y;
    }
    if (d.x <= 0) {
        const int32_t x = d.x;
        eighth += 2;
        d.x = d.y;
        d.y = -x;
    }
    return eighth + (d.y >= d.x);
}

/* True when d lies on the ray of an angle or clockwise of it, up to angle 0.
 * Rays lie in the eighths of their angles, so the ray itself is needed in its
 * own eighth only, where the two are less than a quarter turn apart. */
static bool is_behind(struct pel_point d, uint16_t turn)
{
    const int32_t eighth = eighth_of(d), of_ray = turn >> 13;
    if (eighth != of_ray)
        return eighth > of_ray;
    const struct pel_point ray = pel_direction(turn);
    return pel_product(ray.x, d.y) >= pel_product(ray.y, d.x);
}

/* True in the range of angles around the centre (rule: round/angle_range.h). */
static PEL_NOINLINE bool in_angles(struct pel_point center, int32_t from,
                                   int32_t to, struct pel_point p)
{
    struct pel_angles a;
    struct pel_point d = {p.x - center.x, p.y - center.y};
    if (d.x == 0 && d.y == 0)
        d.x = 1;
    if (!pel_angles_set(&a, from, to))
        return false;
    if (a.from < a.to)
        return is_behind(d, a.from) && !is_behind(d, a.to);
    return is_behind(d, a.from) || !is_behind(d, a.to);
}

bool pel_hit_circle(struct pel_point center, int32_t radius, int32_t x,
                    int32_t y)
{
    struct pel_point p;
    return set_point(x, y, &p) && pel_point_legal(center) &&
           pel_radius_legal(radius) && in_disc(p, center, radius);
}

bool pel_hit_ring(const struct pel_ring_shape *ring, int32_t x, int32_t y)
{
    struct pel_point p;
    return set_point(x, y, &p) && pel_point_legal(ring->center) &&
           pel_radius_legal(ring->inner) && pel_radius_legal(ring->outer) &&
           in_disc(p, ring->center, ring->outer) &&
           !in_disc(p, ring->center, ring->inner);
}

bool pel_hit_sector(const struct pel_sector_shape *sector, int32_t x, int32_t y)
{
    struct pel_point p;
    return set_point(x, y, &p) &&
           pel_hit_circle(sector->center, sector->radius, x, y) &&
           in_angles(sector->center, sector->from, sector->to, p);
}

bool pel_hit_arc(const struct pel_arc_shape *arc, int32_t x, int32_t y)
{
    const struct pel_ring_shape ring = {arc->center, arc->inner, arc->outer};
    struct pel_point p;
    return set_point(x, y, &p) && pel_hit_ring(&ring, x, y) &&
           in_angles(arc->center, arc->from, arc->to, p);
}

/* high 2^64 + low. */
struct product {
    uint64_t high, low;
};

/* a b for a, b <= 2^46, by halves of 32 bits: the middle sum is below 2^48. */
static struct product multiply(uint64_t a, uint64_t b)
{
    uint64_t a0 = (uint32_t)a, a1 = a >> 32, b0 = (uint32_t)b, b1 = b >> 32;
    uint64_t low = a0 * b0, middle = a0 * b1 + a1 * b0 + (low >> 32);
    return (struct product){a1 * b1 + (middle >> 32),
                            middle << 32 | (uint32_t)low};
}

/* (u b)^2 + (v a)^2 <= (a b)^2 for a, b < 2^15: products below 2^30. */
static bool hit_small(int32_t u, int32_t v, struct pel_point r)
{
    return pel_square(u * r.y) + pel_square(v * r.x) <= pel_square(r.x * r.y);
}

bool pel_hit_ellipse(const struct pel_ellipse_shape *ellipse, int32_t x,
                     int32_t y)
{
    const struct pel_point c = ellipse->center, r = ellipse->radius;
    struct pel_point p;
    if (!set_point(x, y, &p) || !pel_point_legal(c) || !pel_radius_legal(r.x) ||
        !pel_radius_legal(r.y) || p.x < c.x - r.x || p.x > c.x + r.x ||
        p.y < c.y - r.y || p.y > c.y + r.y)
        return false;
    if (r.x < 32768 && r.y < 32768)
        return hit_small(p.x - c.x, p.y - c.y, r);
    /* u^2 b^2 <= a^2 (b^2 - v^2) */
    int64_t b2 = pel_square(r.y);
    struct product left =
        multiply((uint64_t)pel_square(p.x - c.x), (uint64_t)b2);
    struct product right = multiply((uint64_t)pel_square(r.x),
                                    (uint64_t)(b2 - pel_square(p.y - c.y)));
    return left.high < right.high ||
           (left.high == right.high && left.low <= right.low);
}

/* +1 or -1 when the side from a to b crosses the row of p, downwards or
 * upwards, on or left of p; else 0: the rule of raster/edge.h. The products are
 * below 2^49. */
static int32_t crossing(const struct pel_point *a, const struct pel_point *b,
                        struct pel_point p)
{
    int32_t winding = 1;
    if (a->y > b->y) {
        const struct pel_point *t = a;
        a = b;
        b = t;
        winding = -1;
    }
    if (p.y < a->y || p.y >= b->y)
        return 0;
    if (p.x < a->x && p.x < b->x)
        return 0;
    if (p.x >= a->x && p.x >= b->x)
        return winding;
    int64_t right = pel_product(p.x - a->x, b->y - a->y);
    int64_t edge = pel_product(p.y - a->y, b->x - a->x);
    return right >= edge ? winding : 0;
}

bool pel_hit_polygon(const struct pel_polygon_shape *polygon, int32_t x,
                     int32_t y)
{
    const struct pel_point *v = polygon->v;
    const int32_t n = polygon->n;
    struct pel_point p;
    if (n < 3 || !set_point(x, y, &p) || !pel_points_legal(v, n))
        return false;
    int32_t winding = 0;
    const struct pel_point *previous = &v[n - 1];
    for (int32_t i = 0; i < n; i++) {
        winding += crossing(previous, &v[i], p);
        previous = &v[i];
    }
    return polygon->rule == PEL_EVEN_ODD ? winding & 1 : winding != 0;
}

bool pel_hit_triangle(const struct pel_point v[3], int32_t x, int32_t y)
{
    const struct pel_polygon_shape polygon = {v, 3, PEL_NON_ZERO};
    return pel_hit_polygon(&polygon, x, y);
}

/* True when b is b1 a / length rounded to the nearest, a tie up, and a is in 0
 * to length, which may be negative. |b1| <= |length| < 2^16. */
static bool on_line(int32_t a, int32_t b, int32_t length, int32_t b1)
{
    if (length < 0) {
        a = -a;
        length = -length;
    }
    if (a < 0 || a > length)
        return false;
    int64_t rest = (int64_t)2 * b1 * a + length - (int64_t)2 * length * b;
    return length ? rest >= 0 && rest < 2 * length : b == 0;
}

bool pel_hit_line(struct pel_point from, struct pel_point to, int32_t x,
                  int32_t y)
{
    struct pel_point p;
    if (!set_point(x, y, &p) || !pel_point_legal(from) || !pel_point_legal(to))
        return false;
    int32_t x0 = pel_pixel_of(from.x), y0 = pel_pixel_of(from.y);
    int32_t dx = pel_pixel_of(to.x) - x0, dy = pel_pixel_of(to.y) - y0;
    x -= x0;
    y -= y0;
    if (pel_magnitude(dx) >= pel_magnitude(dy))
        return on_line(x, y, dx, dy);
    return on_line(y, x, dy, dx);
}

/* Sub-pixels; more than rounding moves a corner (thick_line.h). */
enum { MARGIN = 2 };

enum place { OUTSIDE, INSIDE, AT_EDGE };

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
    const int32_t most = pel_magnitude(dx) + pel_magnitude(dy);
    const int32_t least = pel_max(pel_magnitude(dx), pel_magnitude(dy));
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
    if (!set_point(x, y, &p) || !pel_point_legal(line->from) ||
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
