#include "hit.h"

#include "../base/trig.h"
#include "../raster/crossing.h"
#include "../round/angle_range.h"

/* Sets *p to the centre of pixel (x, y); false when that is out of range. */
static inline bool set_point(int32_t x, int32_t y, struct pel_point *p)
{
    if (!pel_pixel_legal(x, y))
        return false;
    *p = (struct pel_point){pel_pixel_center(x), pel_pixel_center(y)};
    return true;
}

static bool may_hit(const struct pel_rect *box, int32_t x, int32_t y)
{
    return pel_rect_empty(box) ||
           (x >= box->x0 && x < box->x1 && y >= box->y0 && y < box->y1);
}

int32_t pel_hit_topmost(const struct pel_target *const *targets, int32_t n,
                        int32_t x, int32_t y)
{
    while (n > 0) {
        const struct pel_target *t = targets[--n];
        if (may_hit(&t->box, x, y) && t->hit(t, x, y))
            return n;
    }
    return -1;
}

bool pel_hit_rectangle(struct pel_point from, struct pel_point to, int32_t x,
                       int32_t y)
{
    struct pel_point p;
    return set_point(x, y, &p) && pel_point_legal(from) &&
           pel_point_legal(to) && from.x <= p.x && p.x < to.x &&
           from.y <= p.y && p.y < to.y;
}

/* Most pixels are outside of the disc's square. */
bool pel_hit_circle(struct pel_point center, int32_t radius, int32_t x,
                    int32_t y)
{
    struct pel_point p;
    if (!set_point(x, y, &p) || !pel_point_legal(center) ||
        !pel_radius_legal(radius))
        return false;
    const int32_t dx = p.x - center.x, dy = p.y - center.y;
    return pel_magnitude(dx) <= radius && pel_magnitude(dy) <= radius &&
           pel_square(dx) + pel_square(dy) <= pel_square(radius);
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
    if (!pel_hit_rectangle(from, to, x, y) ||
        !pel_radius_legal(rectangle->radius))
        return false;
    int32_t half = pel_min(to.x - from.x, to.y - from.y) / 2;
    int32_t r = pel_min(rectangle->radius, half);
    const struct pel_point inner = {
        nearest(pel_pixel_center(x), from.x + r, to.x - r),
        nearest(pel_pixel_center(y), from.y + r, to.y - r)};
    return pel_hit_circle(inner, r, x, y);
}

/* Positive where d lies clockwise of the ray, by up to half a turn; 0 on it. */
static int64_t side_of(uint16_t turn, struct pel_point d)
{
    const struct pel_point ray = pel_direction(turn);
    return pel_product(ray.x, d.y) - pel_product(ray.y, d.x);
}

/* The eighth of a turn that holds the angle of d, which is not 0. */
static int32_t octant_of(struct pel_point d)
{
    int32_t octant = 0;
    if (d.y < 0 || (d.y == 0 && d.x < 0)) {
        d = (struct pel_point){-d.x, -d.y};
        octant = 4;
    }
    if (d.x <= 0) {
        d = (struct pel_point){d.y, -d.x};
        octant += 2;
    }
    return octant + (d.y >= d.x);
}

/* True in the range of angles around the centre (rule: round/angle_range.h).
 * Only in the octants of its ends is a direction needed: one, where these are
 * two octants. A range that begins and ends in one is small, or holds all
 * others and the octant's part before or after the gap. */
static PEL_NOINLINE bool in_angles(struct pel_point center, int32_t from,
                                   int32_t to, int32_t x, int32_t y)
{
    struct pel_angles a;
    struct pel_point d = {pel_pixel_center(x) - center.x,
                          pel_pixel_center(y) - center.y};
    if (d.x == 0 && d.y == 0)
        d.x = 1;
    if (!pel_angles_set(&a, from, to))
        return false;
    const uint16_t size = (uint16_t)(a.to - a.from);
    const int32_t first = a.from >> 13, last = a.to >> 13;
    const int32_t octant = octant_of(d);
    const bool around = first == last && size > 8192;
    if (size == 0)
        return true;
    if (octant != first && octant != last)
        return around || ((octant - first) & 7) < ((last - first) & 7);
    const bool begun = octant != first || side_of(a.from, d) >= 0;
    const bool open = octant != last || side_of(a.to, d) < 0;
    return around ? begun || open : begun && open;
}

bool pel_hit_ring(const struct pel_ring_shape *ring, int32_t x, int32_t y)
{
    return pel_hit_circle(ring->center, ring->outer, x, y) &&
           pel_radius_legal(ring->inner) &&
           !pel_hit_circle(ring->center, ring->inner, x, y);
}

bool pel_hit_sector(const struct pel_sector_shape *sector, int32_t x, int32_t y)
{
    return pel_hit_circle(sector->center, sector->radius, x, y) &&
           in_angles(sector->center, sector->from, sector->to, x, y);
}

bool pel_hit_arc(const struct pel_arc_shape *arc, int32_t x, int32_t y)
{
    const struct pel_ring_shape ring = {arc->center, arc->inner, arc->outer};
    return pel_hit_ring(&ring, x, y) &&
           in_angles(arc->center, arc->from, arc->to, x, y);
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

bool pel_hit_ellipse(const struct pel_ellipse_shape *ellipse, int32_t x,
                     int32_t y)
{
    const struct pel_point c = ellipse->center, r = ellipse->radius;
    struct pel_point p;
    if (!set_point(x, y, &p) || !pel_point_legal(c) || !pel_radius_legal(r.x) ||
        !pel_radius_legal(r.y) || p.x < c.x - r.x || p.x > c.x + r.x ||
        p.y < c.y - r.y || p.y > c.y + r.y)
        return false;
    /* u^2 b^2 <= a^2 (b^2 - v^2) */
    int64_t b2 = pel_square(r.y);
    struct product left =
        multiply((uint64_t)pel_square(p.x - c.x), (uint64_t)b2);
    struct product right = multiply((uint64_t)pel_square(r.x),
                                    (uint64_t)(b2 - pel_square(p.y - c.y)));
    return left.high < right.high ||
           (left.high == right.high && left.low <= right.low);
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
        winding += pel_crossing(previous, &v[i], p);
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
    int64_t remainder = (int64_t)2 * b1 * a + length - (int64_t)2 * length * b;
    return length ? remainder >= 0 && remainder < 2 * length : b == 0;
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

static bool in_box(const struct pel_rect *box, struct pel_point p)
{
    return p.x >= box->x0 && p.x <= box->x1 && p.y >= box->y0 && p.y <= box->y1;
}

/* The box comes first, as the corners take a root. */
bool pel_hit_thick_line(const struct pel_thick_line_shape *line, int32_t x,
                        int32_t y)
{
    struct pel_point p, v[4];
    const struct pel_polygon_shape polygon = {v, 4, PEL_NON_ZERO};
    if (!set_point(x, y, &p) || !pel_thick_line_legal(line))
        return false;
    const struct pel_rect box = pel_thick_line_box(line);
    return in_box(&box, p) && pel_thick_line_corners(line, v) &&
           pel_hit_polygon(&polygon, x, y);
}
