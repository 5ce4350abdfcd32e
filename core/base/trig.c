#include "trig.h"

/* Sine and cosine of an eighth of a turn as polynomials in z = (f / 8192)^2,
 * f = 0..8192, z as 26-bit fraction: minimax through Chebyshev nodes, the
 * coefficients in 2^-32 with alternating signs,
 *     sin = f / 8192 (s0 - z (s1 - z (s2 - z s3)))
 *     cos = 1 - z (c0 - z (c1 - z (c2 - z c3))).
 * The error stays below 2^-27 before the last rounding, to 2^-15; that every
 * result is the nearest is no consequence of this bound but was found by trying
 * all of them, and a test does so again. Products: z <= 2^26 times a
 * coefficient below 2^32 fits 58 bits. */
static uint32_t polynomial(uint32_t z, const uint32_t c[4])
{
    uint32_t v = c[3];
    for (int i = 2; i >= 0; i--)
        v = c[i] - (uint32_t)(pel_multiply(z, v) >> 26);
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
    const uint64_t drop = pel_multiply(f * f, polynomial(f * f, c)) >> 26;
    return (int32_t)(((UINT64_C(1) << 32) - drop + (UINT32_C(1) << 16)) >> 17);
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
