#include "gouraud.h"

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

/* 1 / area as bits 2^-shift, bits in [2^31, 2^32]. */
struct reciprocal {
    uint64_t bits;
    int shift;
    bool negative;
};

struct setup {
    const struct pel_point *a, *b, *c; /* top to bottom */
    int64_t area;
    bool exact; /* long division, not the reciprocal */
    struct reciprocal inverse;
};

/* The reciprocal is good to 2^-30 of its value: 2^-31 by its own last bit, as
 * much by the area's, if it had to be cut to 32 bits. With D the longer side of
 * the box and area >= 16 D a gradient is at most 510 D 2^32 / 16 D < 2^37, and
 * so off by less than 2^7 steps of 2^-24: 2^-17 per pixel, the bound of the
 * header. With D <= 2^20 (4,096 px) that is 2^-4 at most, and a numerator,
 * |n| <= 510 D, times the bits fits 2^61. */
static bool reciprocal_is_enough(const struct setup *s)
{
    int64_t area = s->area < 0 ? -s->area : s->area;
    int32_t x0 = pel_min(pel_min(s->a->x, s->b->x), s->c->x);
    int32_t x1 = pel_max(pel_max(s->a->x, s->b->x), s->c->x);
    int32_t longer = pel_max(x1 - x0, s->c->y - s->a->y);
    return longer <= 1048576 && area >= (int64_t)16 * longer;
}

/* area = word 2^-shift with word in [2^31, 2^32), then 2^63 / word. */
static struct reciprocal reciprocal_of(int64_t area)
{
    struct reciprocal r = {0, 0, area < 0};
    uint64_t word = (uint64_t)(area < 0 ? -area : area);
    for (; word > UINT64_C(0xFFFFFFFF); r.shift--)
        word >>= 1;
    for (int step = 16; step > 0; step /= 2)
        if (word < UINT64_C(1) << (32 - step)) {
            word <<= step;
            r.shift += step;
        }
    r.bits = UINT64_C(0x8000000000000000) / word;
    return r;
}

/* n 2^32 / area = n 2^(32 + shift) / word = n bits 2^(shift - 31). 16 <= area <
 * 2^42 here, so -10 <= shift <= 27. */
static gradient by_reciprocal(const struct reciprocal *r, int64_t n)
{
    uint64_t product = (uint64_t)(n < 0 ? -n : n) * r->bits >> (31 - r->shift);
    return (n < 0) != r->negative ? 0 - product : product;
}

/* floor(n 2^32 / area) by digits of 8 bits: |area| < 2^50, so a remainder and
 * its digit fit 2^58. The quotient may have 66 bits and wraps. */
static gradient by_long_division(int64_t n, int64_t area)
{
    if (area < 0) {
        n = -n;
        area = -area;
    }
    int64_t rest = n % area;
    gradient q = (gradient)(n / area);
    if (rest < 0) {
        rest += area;
        q--;
    }
    for (int digit = 0; digit < 4; digit++) {
        rest *= 256;
        q = q * 256 + (gradient)(rest / area);
        rest %= area;
    }
    return q;
}

static gradient gradient_of(const struct setup *s, int64_t n)
{
    return s->exact ? by_long_division(n, s->area)
                    : by_reciprocal(&s->inverse, n);
}

/* Channel k. The anchor is the pixel of A: at its centre the value is a plus
 * the gradients times the way there, -127..128 sub-pixels in x and y. From
 * there back to pixel (0, 0). Bits 8..39 of `way` are what 32 bits of 8.24 need
 * of it, and those are right modulo 2^64. */
static void set_channel(struct pel_gouraud *p, const struct setup *s, int k,
                        const int32_t value[3])
{
    const int32_t b = value[1] - value[0], c = value[2] - value[0];
    gradient gx = gradient_of(s, (int64_t)b * (s->c->y - s->a->y) -
                                     (int64_t)c * (s->b->y - s->a->y));
    gradient gy = gradient_of(s, (int64_t)c * (s->b->x - s->a->x) -
                                     (int64_t)b * (s->c->x - s->a->x));
    const int32_t x = pel_pixel_of(s->a->x), y = pel_pixel_of(s->a->y);
    gradient way = gx * (gradient)(int64_t)(pel_pixel_center(x) - s->a->x) +
                   gy * (gradient)(int64_t)(pel_pixel_center(y) - s->a->y);
    p->dx[k] = (uint32_t)gx;
    p->dy[k] = (uint32_t)gy;
    p->at[k] = ((uint32_t)value[0] << 24) + 0x800000u + (uint32_t)(way >> 8) -
               (uint32_t)x * p->dx[k] - (uint32_t)y * p->dy[k];
}

static void set_level(struct pel_gouraud *p, int k, uint32_t value)
{
    p->at[k] = (value << 24) + 0x800000u;
    p->dx[k] = 0;
    p->dy[k] = 0;
}

void pel_gouraud_init(struct pel_gouraud *paint, const struct pel_point v[3],
                      const pel_color c[3])
{
    const struct pel_point *p[3] = {&v[0], &v[1], &v[2]};
    pel_sort3(p);
    struct setup s = {.a = p[0], .b = p[1], .c = p[2]};
    const struct pel_point sorted[3] = {*s.a, *s.b, *s.c};
    const pel_color color[3] = {c[s.a - v], c[s.b - v], c[s.c - v]};
    s.area = pel_points_legal(v, 3) ? pel_triangle_area(sorted) : 0;
    s.exact = s.area == 0 || !reciprocal_is_enough(&s);
    s.inverse = reciprocal_of(s.exact ? 1 : s.area);
    paint->paint = (struct pel_paint){pel_gouraud_fill, PEL_GOURAUD_FAST};
    paint->opaque = pel_alpha(c[0] & c[1] & c[2]) == 255;
    for (int k = 0; k < 4; k++) {
        const int32_t value[3] = {(int32_t)(color[0] >> 8 * k & 255),
                                  (int32_t)(color[1] >> 8 * k & 255),
                                  (int32_t)(color[2] >> 8 * k & 255)};
        if (s.area == 0 || (value[0] == value[1] && value[1] == value[2]))
            set_level(paint, k, (uint32_t)value[0]);
        else
            set_channel(paint, &s, k, value);
    }
}

void pel_triangle_gouraud(const struct pel_surface *surface,
                          const struct pel_point v[3], const pel_color c[3])
{
    struct pel_gouraud paint;
    pel_gouraud_init(&paint, v, c);
    pel_triangle(surface, v, &paint.paint);
}
