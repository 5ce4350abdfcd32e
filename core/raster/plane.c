#include "plane.h"

#include "../base/divide.h"
#include "triangle_sort.h"

#if !PEL_64BIT
uint64_t pel_plane_at(const struct pel_plane *p, int32_t x, int32_t y)
{
    return p->at + pel_times(p->dx, x) + pel_times(p->dy, y);
}
#endif

/* With reciprocals where multiplications are fast and divisions are not. */
#if PEL_LONG_MULTIPLY && !PEL_64BIT

/* The upper half of a b. */
static PEL_NOINLINE_32 uint64_t multiply_high(uint64_t a, uint64_t b)
{
    const uint64_t al = a & 0xFFFFFFFFu, ah = a >> 32;
    const uint64_t bl = b & 0xFFFFFFFFu, bh = b >> 32;
    const uint64_t cross = ah * bl + (al * bl >> 32);
    const uint64_t other = al * bh + (cross & 0xFFFFFFFFu);
    return ah * bh + (cross >> 32) + (other >> 32);
}

/* word = area 2^(63 - bits), in [2^62, 2^63). r = 2^63 / (word >> 31) is right
 * to 2^-31, so word r 2^-32 differs from 2^62 by less than 2^32; a Newton step
 * with this difference makes r right to 2^-59. */
static void invert(struct pel_plane_setup *s)
{
    s->bits = (uint8_t)pel_bits_of(s->area);
    const uint64_t word = s->area << (63 - s->bits);
    const uint64_t r =
        pel_divide((UINT64_C(1) << 63) - 1, (uint32_t)(word >> 31));
    const int64_t miss =
        (int64_t)((UINT64_C(1) << 62) - multiply_high(word, r << 32)) >> 2;
    s->inverse = (r << 31) + (uint64_t)((int64_t)r * miss >> 29);
}

/* The exact quotient of *n, from one that is off by 1 at most; *n becomes the
 * remainder. */
static PEL_NOINLINE_32 uint64_t exact(uint64_t quotient, uint64_t d,
                                      uint64_t *n)
{
    *n -= quotient * d;
    if ((int64_t)*n < 0) {
        *n += d;
        return quotient - 1;
    }
    if (*n < d)
        return quotient;
    *n -= d;
    return quotient + 1;
}

/* inverse 2^-(62 + bits) is 1 / area, off by less than 2^-58 of itself: no
 * quotient below 2^58 is off by more than 1. */
static uint64_t divide(const struct pel_plane_setup *s, uint64_t n,
                       uint64_t *fine)
{
    uint64_t q = multiply_high(n * 2, s->inverse) >> (s->bits - 1);
    const uint64_t whole = exact(q, s->area, &n);
    q = multiply_high(n << (63 - s->bits), s->inverse) >> 29;
    n <<= 32;
    q = exact(q, s->area, &n);
    *fine = (whole << 24) + (q >> 8);
    return (whole << 32) + q;
}

#else

static void invert(struct pel_plane_setup *s)
{
    (void)s;
}

static uint64_t divide(const struct pel_plane_setup *s, uint64_t n,
                       uint64_t *fine)
{
    return pel_divide_fraction(n, s->area, fine);
}

#endif

/* The gradient of a pixel, cut towards zero; that of a sub-pixel times
 * `distance` is added to *at. Without a branch on the sign, which CPUs cannot
 * predict. */
static PEL_INLINE_64 uint64_t gradient(const struct pel_plane_setup *s,
                                       int64_t n, int32_t distance,
                                       uint64_t *at)
{
    const uint64_t sign = (uint64_t)(n >> 63);
    uint64_t fine;
    if (n == 0)
        return 0;
    n = (int64_t)divide(s, ((uint64_t)n ^ sign) - sign, &fine);
    *at += pel_times((fine ^ sign) - sign, distance);
    return ((uint64_t)n ^ sign) - sign;
}

/* Of equally high vertices the left one. Without branches on CPUs that would
 * have to guess. */
static inline int topmost(const struct pel_point v[3])
{
    const int second = pel_above(&v[1], &v[0]);
    const int third = pel_above(&v[2], &v[second]);
    return PEL_64BIT ? (second & ~third) + 2 * third : third ? 2 : second;
}

void pel_plane_corners(struct pel_plane_setup *setup,
                       const struct pel_point v[3])
{
    int32_t bx = v[1].x - v[0].x, by = v[1].y - v[0].y;
    int32_t cx = v[2].x - v[0].x, cy = v[2].y - v[0].y;
    const int64_t area = pel_product(bx, cy) - pel_product(cx, by);
    const int32_t sign = (int32_t)(area >> 63) | (area != 0);
    bx *= sign;
    by *= sign;
    cx *= sign;
    cy *= sign;
    setup->right[0] = by - cy;
    setup->right[1] = cy;
    setup->right[2] = -by;
    setup->down[0] = cx - bx;
    setup->down[1] = -cx;
    setup->down[2] = bx;
    setup->area = (uint64_t)pel_size_of(area);
    setup->first = (uint8_t)topmost(v);
    setup->a = v[setup->first];
}

bool pel_plane_start(struct pel_plane_setup *setup, const struct pel_point v[3])
{
    pel_plane_corners(setup, v);
    if (setup->area)
        invert(setup);
    return setup->area != 0;
}

/* The gradient of a sub-pixel leads from a to the centre of its pixel, up to
 * 128 sub-pixels away; from there that of a pixel has eight bits more, which
 * keeps the longest distance right to 2^16 2^-24. */
void pel_plane_set(struct pel_plane *plane, const struct pel_plane_setup *setup,
                   const int32_t value[3])
{
    const struct pel_plane_setup *s = setup;
    plane->at = (uint64_t)value[s->first] << 24;
    plane->dx =
        gradient(s, pel_dot(value, s->right), 128 - (s->a.x & 255), &plane->at);
    plane->dy =
        gradient(s, pel_dot(value, s->down), 128 - (s->a.y & 255), &plane->at);
    plane->at =
        pel_plane_at(plane, -pel_pixel_of(s->a.x), -pel_pixel_of(s->a.y));
}
