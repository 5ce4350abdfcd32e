#include "plane.h"

#include "../base/divide.h"
#include "../raster/triangle.h"
#include "../raster/triangle_sort.h"
#include "vector.h"

#if !PEL_64BIT
uint64_t pel_plane_at(const struct pel_plane *p, int32_t x, int32_t y)
{
    return p->at + pel_times(p->dx, x) + pel_times(p->dy, y);
}
#endif

/* Gradients are exact, and cut towards zero: n / area as 2^-24 of a pixel and,
 * in `fine`, of a sub-pixel; modulo 2^64. */
#if PEL_LONG_MULTIPLY

/* The upper and the lower half of a b. */
static uint64_t multiply(uint64_t a, uint64_t b, uint64_t *low)
{
    const uint64_t al = a & 0xFFFFFFFFu, ah = a >> 32;
    const uint64_t bl = b & 0xFFFFFFFFu, bh = b >> 32;
    const uint64_t least = al * bl;
    const uint64_t cross = ah * bl + (least >> 32);
    const uint64_t other = al * bh + (cross & 0xFFFFFFFFu);
    *low = other << 32 | (least & 0xFFFFFFFFu);
    return ah * bh + (cross >> 32) + (other >> 32);
}

/* word = area 2^(63 - bits), in [2^62, 2^63). r = 2^63 / (word >> 31) is right
 * to 2^-31, so word r 2^-32 differs from 2^62 by less than 2^32; a Newton step
 * with this difference makes r right to 2^-59. */
static void invert(struct pel_plane_setup *s)
{
    const int bits = pel_bits_of(s->area);
    const uint64_t word = s->area << (63 - bits);
    const uint64_t r =
        pel_divide((UINT64_C(1) << 63) - 1, (uint32_t)(word >> 31));
    uint64_t low;
    const int64_t miss =
        (int64_t)((UINT64_C(1) << 62) - multiply(word, r << 32, &low)) >> 2;
    s->inverse = (r << 31) + (uint64_t)((int64_t)r * miss >> 29);
    s->shift = (uint8_t)(30 + bits);
}

/* inverse 2^-(shift + 32) is 1 / area, off by less than 2^-58 of itself, so the
 * rest of n 2^32 is below 2^31 + 2^51 in size. */
static uint64_t divide(const struct pel_plane_setup *s, uint64_t n,
                       uint64_t *fine)
{
    uint64_t low, high = multiply(n, s->inverse, &low);
    int shift = s->shift;
    if (shift >= 64) {
        low = high;
        high = 0;
        shift -= 64;
    }
    low = low >> shift | high << 1 << (63 - shift);
    high >>= shift;
    const int64_t left = (int64_t)((n << 32) - low * s->area);
    if (left < 0 || (uint64_t)left >= s->area) {
        const int64_t d = (int64_t)s->area;
        const int64_t more = left / d - (left % d < 0);
        const uint64_t sum = low + (uint64_t)more;
        high += (uint64_t)(more >> 63) + (sum < low);
        low = sum;
    }
    *fine = low >> 8 | high << 56;
    return low;
}

#else

static void invert(struct pel_plane_setup *s)
{
    (void)s;
}

/* Bit by bit, 64 of n and 32 behind them, but for leading zeros. The rest,
 * below 2^50, has room for the next bit. */
static uint64_t divide(const struct pel_plane_setup *s, uint64_t n,
                       uint64_t *fine)
{
    uint64_t q = 0, rest = 0;
    int bits = 96;
    for (; bits > 32 && n >> 63 == 0; bits--)
        n <<= 1;
    for (; bits > 0; bits--) {
        if (bits == 8)
            *fine = q;
        rest = rest * 2 + (n >> 63);
        n <<= 1;
        q *= 2;
        if (rest >= s->area) {
            rest -= s->area;
            q++;
        }
    }
    return q;
}

#endif

static void gradient(const struct pel_plane_setup *s, int64_t n, uint64_t *fine,
                     uint64_t *pixel)
{
    *pixel = divide(s, (uint64_t)pel_size_of(n), fine);
    if (n < 0) {
        *pixel = 0 - *pixel;
        *fine = 0 - *fine;
    }
}

/* From the topmost vertex to vertex i. */
static struct pel_point vector_to(const struct pel_plane_setup *s,
                                  const struct pel_point v[3], int i)
{
    return (struct pel_point){v[i].x - s->a.x, v[i].y - s->a.y};
}

/* The second and third vertices are in the order that makes the area positive.
 */
bool pel_plane_start(struct pel_plane_setup *setup, const struct pel_point v[3])
{
    struct pel_plane_setup *s = setup;
    const int64_t area = pel_triangle_area(v);
    const int a = pel_topmost(v), b = a == 2 ? 0 : a + 1;
    s->first = (uint8_t)a;
    s->second = (uint8_t)(area < 0 ? 3 - a - b : b);
    s->third = (uint8_t)(area < 0 ? b : 3 - a - b);
    s->a = v[a];
    s->ab = vector_to(s, v, s->second);
    s->ac = vector_to(s, v, s->third);
    s->area = (uint64_t)pel_size_of(area);
    if (area)
        invert(s);
    return area != 0;
}

/* With nx = (vb - va) ac.y - (vc - va) ab.y, below 2^57, the gradient is nx /
 * area; in y alike. The gradient of a sub-pixel leads from a to the centre of
 * its pixel, up to 128 sub-pixels away; from there that of a pixel has eight
 * bits more, which keeps the longest distance right to 2^16 2^-24. */
void pel_plane_set(struct pel_plane *plane, const struct pel_plane_setup *setup,
                   const int32_t value[3])
{
    const struct pel_plane_setup *s = setup;
    const int32_t top = value[s->first];
    const int32_t b = value[s->second] - top, c = value[s->third] - top;
    const int32_t x = pel_pixel_of(s->a.x), y = pel_pixel_of(s->a.y);
    struct pel_plane fine;
    *plane = pel_plane_level(top);
    if (b == 0 && c == 0)
        return;
    fine.at = plane->at;
    gradient(s, pel_minor(b, s->ac.y, c, s->ab.y), &fine.dx, &plane->dx);
    gradient(s, pel_minor(c, s->ab.x, b, s->ac.x), &fine.dy, &plane->dy);
    plane->at = pel_plane_at(&fine, pel_pixel_center(x) - s->a.x,
                             pel_pixel_center(y) - s->a.y);
    plane->at = pel_plane_at(plane, -x, -y);
}
