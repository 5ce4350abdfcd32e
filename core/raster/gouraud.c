#include "gouraud.h"

#include "../base/divide.h"
#include "../base/fraction.h"
#include "triangle_sort.h"

/* The plane of channel values a, b, c at A, B, C is, in sub-pixels,
 *
 *     a + (nx (X - A.x) + ny (Y - A.y)) / area
 *
 * with nx = (b - a)(C.y - A.y) - (c - a)(B.y - A.y), ny alike and the area of
 * pel_triangle_area. A step of one pixel is nx 256 / area, in 8.24:
 * nx 2^32 / area. One reciprocal serves all channels where it is close enough;
 * elsewhere (large or very thin triangles) a long division is exact. */

/* n 2^32 / area modulo 2^64, two's complement; n is nx or ny. */
typedef uint64_t gradient;

/* The planes start at a, the topmost vertex, of two the left one. Swapping b
 * and c changes nothing: numerators and area change their signs together. */
struct setup {
    struct pel_point a, b, c;
    int64_t area;
    bool exact;      /* long division, not the reciprocal */
    int64_t inverse; /* 2^63 / word with the sign of area, |area| = word
                        2^-shift and word in [2^31, 2^32) */
    int shift;
};

/* The reciprocal is good to 2^-30 of its value: 2^-31 by its own last bit, as
 * much by the area's, if it had to be cut to 32 bits. A numerator is the
 * difference of two products, each of two values' difference, at most 255, and
 * two coordinates', at most D, the longer side of the box: |n| <= 510 D. With
 * area >= 16 D a gradient is at most 510 D 2^32 / 16 D < 2^37, and so off by
 * less than 2^7 steps of 2^-24: 2^-17 per pixel, the bound of the header. With
 * D <= 2^20 (4,096 px) that is 2^-4 at most, and a numerator, below 2^29, times
 * the inverse, at most 2^32, fits 2^61. */
static bool reciprocal_is_enough(const struct setup *s)
{
    int64_t area = s->area < 0 ? -s->area : s->area;
    int32_t x0 = pel_min(pel_min(s->a.x, s->b.x), s->c.x);
    int32_t x1 = pel_max(pel_max(s->a.x, s->b.x), s->c.x);
    int32_t longer = pel_max(x1 - x0, pel_max(s->b.y, s->c.y) - s->a.y);
    return longer <= 1048576 && area >= (int64_t)16 * longer;
}

/* floor(n 2^32 / d) modulo 2^64, 0 <= n < 2^34, 0 < d < 2^50. */
static gradient divide(uint64_t n, uint64_t d)
{
#if PEL_FAST_64BIT && defined(__GNUC__)
    return pel_fraction_of((int64_t)n, (int64_t)d, 32);
#else
    uint64_t rest = 0;
    return pel_divide_bits(n << 30, d, 66, &rest);
#endif
}

#if PEL_FAST_64BIT && defined(__GNUC__)
static int64_t with_sign_of(int64_t area, int64_t v)
{
    return area < 0 ? -v : v;
}

static void set_reciprocal(struct setup *s)
{
    const uint64_t area = (uint64_t)with_sign_of(s->area, s->area);
    const int zeros = __builtin_clzll(area);
    s->shift = zeros - 32;
    s->inverse = with_sign_of(
        s->area, (int64_t)((UINT64_C(1) << 63) / (area << zeros >> 32)));
}
#else
/* s->shift is 0 before. */
static void set_reciprocal(struct setup *s)
{
    uint64_t word = (uint64_t)(s->area < 0 ? -s->area : s->area);
    for (; word > UINT64_C(0xFFFFFFFF); s->shift--)
        word >>= 1;
    for (int step = 16; step > 0; step /= 2)
        if (word < UINT64_C(1) << (32 - step)) {
            word <<= step;
            s->shift += step;
        }
    s->inverse = (int64_t)divide(UINT64_C(0x80000000), word);
    if (s->area < 0)
        s->inverse = -s->inverse;
}
#endif

/* n 2^32 / area = n 2^(32 + shift) / word = n inverse 2^(shift - 31). 16 <=
 * |area| < 2^42 here, so -10 <= shift <= 27. */
static gradient by_reciprocal(const struct setup *s, int64_t n)
{
    return (gradient)(n * s->inverse >> (31 - s->shift));
}

/* Rounds towards zero. */
static gradient by_long_division(int64_t n, int64_t area)
{
    gradient q =
        divide((uint64_t)(n < 0 ? -n : n), (uint64_t)(area < 0 ? -area : area));
    return (n < 0) != (area < 0) ? 0 - q : q;
}

static gradient gradient_of(const struct setup *s, int64_t n)
{
    return s->exact ? by_long_division(n, s->area) : by_reciprocal(s, n);
}

/* Sets channel k from its values at a, b, c. At the centre of a's pixel the
 * value is that at a plus the gradients times the offset, -127..128 sub-pixels
 * in x and y; from there the plane is traced back to pixel (0, 0). Bits 8..39
 * of `sum` are the 32 bits of 8.24, and are right modulo 2^64. */
static PEL_WIDE void set_channel(struct pel_gouraud *p, const struct setup *s,
                                 int k, const int32_t value[3])
{
    const int32_t b = value[1] - value[0], c = value[2] - value[0];
    gradient gx = gradient_of(s, (int64_t)b * (s->c.y - s->a.y) -
                                     (int64_t)c * (s->b.y - s->a.y));
    gradient gy = gradient_of(s, (int64_t)c * (s->b.x - s->a.x) -
                                     (int64_t)b * (s->c.x - s->a.x));
    const int32_t x = pel_pixel_of(s->a.x), y = pel_pixel_of(s->a.y);
    gradient sum = gx * (gradient)(int64_t)(pel_pixel_center(x) - s->a.x) +
                   gy * (gradient)(int64_t)(pel_pixel_center(y) - s->a.y);
    p->dx[k] = (uint32_t)gx;
    p->dy[k] = (uint32_t)gy;
    p->at[k] = ((uint32_t)value[0] << 24) + 0x800000u + (uint32_t)(sum >> 8) -
               (uint32_t)x * p->dx[k] - (uint32_t)y * p->dy[k];
}

static void set_geometry(struct setup *s)
{
    s->area = (int64_t)(s->b.x - s->a.x) * (s->c.y - s->a.y) -
              (int64_t)(s->c.x - s->a.x) * (s->b.y - s->a.y);
    s->exact = s->area == 0 || !reciprocal_is_enough(s);
    if (!s->exact)
        set_reciprocal(s);
}

enum pel_status pel_gouraud_init(struct pel_gouraud *paint,
                                 const struct pel_point v[3],
                                 const pel_color c[3])
{
    if (paint)
        pel_paint_clear(&paint->paint);
    if (!paint || !v || !c)
        return PEL_ERROR_NULL;
    if (!pel_points_legal(v, 3))
        return PEL_ERROR_RANGE;
    const int a = pel_topmost(v), b = a == 0, last = 3 - a - b;
    struct setup s = {.a = v[a], .b = v[b], .c = v[last]};
    const bool opaque = pel_alpha(c[0] & c[1] & c[2]) == 255;
    paint->paint =
        (struct pel_paint)PEL_PAINT(pel_gouraud_fill, pel_gouraud_fast);
    set_geometry(&s);
    for (int k = 0; k < 4; k++) {
        const int32_t value[3] = {(int32_t)(c[a] >> 8 * k & 255),
                                  (int32_t)(c[b] >> 8 * k & 255),
                                  (int32_t)(c[last] >> 8 * k & 255)};
        paint->at[k] = ((uint32_t)value[0] << 24) + 0x800000u;
        paint->dx[k] = 0;
        paint->dy[k] = 0;
        if (s.area != 0 && !(k == 3 && opaque))
            set_channel(paint, &s, k, value);
    }
    return PEL_OK;
}

void pel_triangle_gouraud(const struct pel_surface *surface,
                          const struct pel_point v[3], const pel_color c[3])
{
    struct pel_gouraud paint;
    enum pel_status status = pel_gouraud_init(&paint, v, c);
    PEL_ASSERT(status == PEL_OK);
    if (status == PEL_OK)
        pel_triangle(surface, v, &paint.paint);
}
