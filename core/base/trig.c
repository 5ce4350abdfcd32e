#include "trig.h"

#include "divide.h"

/* Sine and cosine of an eighth of a turn as polynomials in z = (f / 8192)^2,
 * f = 0..8192, z as 26-bit fraction: minimax through Chebyshev nodes, the
 * coefficients in 2^-32 with alternating signs,
 *     sin = f / 8192 (s0 - z (s1 - z (s2 - z s3)))
 *     cos = 1 - z (c0 - z (c1 - z (c2 - z c3))).
 * The error stays below 2^-27 before the last rounding, to 2^-15; that every
 * result is the nearest is no consequence of this bound but was found by trying
 * all of them, and a test does so again. Products: z <= 2^26 times a
 * coefficient below 2^32 fits 58 bits. */
static PEL_ALWAYS_INLINE uint32_t polynomial(uint32_t z, const uint32_t c[4])
{
    uint32_t v = c[3];
    for (int i = 2; i >= 0; i--) {
        const uint64_t product = pel_multiply(z, v);
        /* on a line of its own: c[i] needs no register during the product */
        v = c[i] - (uint32_t)(product >> 26);
    }
    return v;
}

static int32_t sine(uint32_t f)
{
    static const uint32_t c[4] = {UINT32_C(3373259416), 346799001, 10694498,
                                  154423};
    return (int32_t)((pel_multiply(f, polynomial(f * f, c)) +
                      (UINT32_C(1) << 29)) >>
                     30);
}

static int32_t cosine(uint32_t f)
{
    static const uint32_t c[4] = {1324675878, 68093864, 1399993, 15213};
    const uint32_t drop =
        (uint32_t)(pel_multiply(f * f, polynomial(f * f, c)) >> 26);
    return 32768 - (int32_t)((drop + 65535) >> 17);
}

struct pel_point pel_direction(uint16_t turn)
{
    uint32_t octant = turn >> 13, f = turn & 8191u;
    if (octant & 1)
        f = 8192 - f;
    struct pel_point d = {cosine(f), sine(f)};
    if ((octant + 1) & 2) /* nearer to the y axis */
        d = (struct pel_point){d.y, d.x};
    if (octant >= 2 && octant < 6)
        d.x = -d.x;
    if (octant >= 4)
        d.y = -d.y;
    return d;
}

/* Differences of legal points are below 2^24, so both sums are below 2^41. */
struct pel_point pel_turned(struct pel_point p, struct pel_point center,
                            int32_t turn)
{
    const struct pel_point d = pel_direction((uint16_t)turn);
    const int32_t x = p.x - center.x, y = p.y - center.y;
    const int64_t right = pel_product(x, d.x) - pel_product(y, d.y);
    const int64_t down = pel_product(x, d.y) + pel_product(y, d.x);
    return (struct pel_point){center.x + (int32_t)((right + 16384) >> 15),
                              center.y + (int32_t)((down + 16384) >> 15)};
}

/* Turns of atan(k / 16), in 2^-32. */
static const uint32_t arctangent[17] = {
    0,         42667331,  85004756,  126697423, 167458907, 207041579,
    245243172, 281909457, 316933406, 350251643, 381839095, 411702716,
    439875013, 466407904, 491367227, 514828063, 536870912,
};

/* atan(w) in 2^-32 turns for w = n / d in [0, 1/32], n < 2^24, by the series
 * w - w^3/3 + w^5/5: the next term is 4e-12. w in 2^-36 is at most 2^31. */
static uint32_t small_angle(uint32_t n, uint32_t d)
{
    const uint32_t a1 = PEL_TURNS_OF_RADIAN, a3 = 227855092, a5 = 136713055;
    const uint32_t w = pel_divide((uint64_t)n << 36, d);
    const uint32_t w2 = (uint32_t)(pel_multiply(w, w) >> 36);
    const uint32_t b = a3 - (uint32_t)(pel_multiply(w2, a5) >> 36);
    const uint32_t factor = a1 - (uint32_t)(pel_multiply(w2, b) >> 36);
    return (uint32_t)((pel_multiply(w, factor) + (UINT64_C(1) << 35)) >> 36);
}

/* The angle of (x, y), 0 <= y <= x, 0 < x < 2^25. With k / 16 the nearest to
 * y / x the difference of the angles has the tangent
 * (y - x k/16) / (x + y k/16) = (16 y - k x) / (16 x + k y), at most 1/32. */
static uint32_t first_octant(uint32_t x, uint32_t y)
{
    uint32_t k = (16 * y + x / 2) / x;
    int32_t n = (int32_t)(16 * y - k * x);
    uint32_t d = 16 * x + k * y;
    const uint32_t sign = (uint32_t)n >> 31, minus = 0 - sign;
    return arctangent[k] +
           ((small_angle(((uint32_t)n ^ minus) + sign, d) ^ minus) + sign);
}

uint32_t pel_turn_of(int32_t x, int32_t y)
{
    const uint32_t a = (uint32_t)(x < 0 ? -x : x);
    const uint32_t b = (uint32_t)(y < 0 ? -y : y);
    uint32_t turn = 0;
    if (a >= b && a > 0)
        turn = first_octant(a, b);
    else if (b > 0)
        turn = UINT32_C(0x40000000) - first_octant(b, a);
    if (x < 0)
        turn = UINT32_C(0x80000000) - turn;
    return y < 0 ? 0 - turn : turn;
}
