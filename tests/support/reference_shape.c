#include "reference_shape.h"

#include "reference.h"

static wide center_of(int32_t pixel)
{
    return (wide)pixel * 256 + 128;
}

/* sin(x + quarters * pi / 2), |x| <= pi / 4, by its series. */
static long double sine(long double x, int quarters)
{
    static const int derivative[4] = {0, 1, 0, -1}; /* of the sine at 0 */
    long double term = 1, sum = 0;
    for (int i = 0; i < 30; i++) {
        sum += term * derivative[(i + quarters) % 4];
        term *= x / (i + 1);
    }
    return sum;
}

static int32_t nearest(long double v)
{
    return (int32_t)(v < 0 ? v - 0.5L : v + 0.5L);
}

struct pel_point reference_direction(uint16_t turn)
{
    const long double pi = 3.14159265358979323846264338327950288L;
    const int quarters = (turn + 8192) / 16384;
    const long double x = (turn - quarters * 16384) * pi / 32768;
    return (struct pel_point){nearest(32768 * sine(x, quarters + 1)),
                              nearest(32768 * sine(x, quarters))};
}

struct vector {
    wide x, y;
};

/* 0 for angles from 0 up to a half turn, 1 for the rest. */
static int half_of(struct vector v)
{
    return v.y < 0 || (v.y == 0 && v.x < 0);
}

/* Is the angle of a at least that of b, both from 0 up to a full turn? */
static bool not_before(struct vector a, struct vector b)
{
    if (half_of(a) != half_of(b))
        return half_of(a) > half_of(b);
    return b.x * a.y - b.y * a.x >= 0;
}

/* Does the centre of (x, y) come in [from, to) when all directions around
 * `center` are put in order, clockwise from +x? */
static bool is_between(struct pel_point center, int32_t from, int32_t to,
                       int32_t x, int32_t y)
{
    struct vector at = {center_of(x) - center.x, center_of(y) - center.y};
    const struct pel_point a = reference_direction((uint16_t)from);
    const struct pel_point b = reference_direction((uint16_t)to);
    if (at.x == 0 && at.y == 0)
        at.x = 1;
    bool after_from = not_before(at, (struct vector){a.x, a.y});
    bool after_to = not_before(at, (struct vector){b.x, b.y});
    if (to - (int64_t)from >= 65536)
        return true;
    if ((uint16_t)from <= (uint16_t)to)
        return after_from && !after_to;
    return after_from || !after_to;
}

bool reference_ring_at(const struct pel_ring_shape *ring, int32_t x, int32_t y)
{
    return reference_disc_at(ring->center, ring->outer, x, y) &&
           !reference_disc_at(ring->center, ring->inner, x, y);
}

bool reference_sector_at(const struct pel_sector_shape *sector, int32_t x,
                         int32_t y)
{
    return reference_disc_at(sector->center, sector->radius, x, y) &&
           is_between(sector->center, sector->from, sector->to, x, y);
}

bool reference_arc_at(const struct pel_arc_shape *arc, int32_t x, int32_t y)
{
    return reference_disc_at(arc->center, arc->outer, x, y) &&
           !reference_disc_at(arc->center, arc->inner, x, y) &&
           is_between(arc->center, arc->from, arc->to, x, y);
}

bool reference_ellipse_at(const struct pel_ellipse_shape *e, int32_t x,
                          int32_t y)
{
    wide u = center_of(x) - e->center.x, v = center_of(y) - e->center.y;
    wide a = e->radius.x, b = e->radius.y;
    return u * u <= a * a && v * v <= b * b &&
           u * u * b * b + v * v * a * a <= a * a * b * b;
}

/* How far v lies outside of lo..hi. */
static wide outside(wide v, wide lo, wide hi)
{
    if (v < lo)
        return lo - v;
    return v > hi ? v - hi : 0;
}

bool reference_rounded_at(const struct pel_rounded_shape *r, int32_t x,
                          int32_t y)
{
    const wide px = center_of(x), py = center_of(y);
    wide width = r->to.x - r->from.x, height = r->to.y - r->from.y;
    wide radius = r->radius, shorter = width < height ? width : height;
    if (px < r->from.x || px >= r->to.x || py < r->from.y || py >= r->to.y)
        return false;
    if (radius > shorter / 2)
        radius = shorter / 2;
    wide dx = outside(px, r->from.x + radius, r->to.x - radius);
    wide dy = outside(py, r->from.y + radius, r->to.y - radius);
    return dx * dx + dy * dy <= radius * radius;
}
