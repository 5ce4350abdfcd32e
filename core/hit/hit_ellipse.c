#include "hit.h"

#include "hit_pixel.h"

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
    if (!pel_hit_pixel(x, y, &p) || !pel_point_legal(c) ||
        !pel_radius_legal(r.x) || !pel_radius_legal(r.y) || p.x < c.x - r.x ||
        p.x > c.x + r.x || p.y < c.y - r.y || p.y > c.y + r.y)
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
