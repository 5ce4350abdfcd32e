#include "strip.h"

#include "../base/divide.h"
#include "smooth.h"

#include <stddef.h>

/* Radii are seen in half the size until they are below this. */
enum { SMALL = 40 * 256 };

/* 2^23 / sqrt((i + 32.5) 2^25) - 128 */
static const uint8_t first_guess[96] = {
    126, 122, 119, 115, 112, 108, 105, 102, 100, 97, 94, 92, 89, 87, 84, 82,
    80,  78,  76,  74,  72,  70,  68,  66,  65,  63, 61, 60, 58, 57, 55, 54,
    52,  51,  50,  48,  47,  46,  44,  43,  42,  41, 40, 39, 38, 36, 35, 34,
    33,  32,  31,  30,  30,  29,  28,  27,  26,  25, 24, 23, 23, 22, 21, 20,
    19,  19,  18,  17,  16,  16,  15,  14,  14,  13, 12, 12, 11, 10, 10, 9,
    9,   8,   7,   7,   6,   6,   5,   4,   4,   3,  3,  2,  2,  1,  1,  0,
};

/* 2^10 sqrt(n) of n >= 2^30, off by less than 4. With x = n / 2^16, a step of
 * Newton's iteration gives r = 2^23 / sqrt(x) to 2^-13 of it. So x r is a root
 * that is off by less than 10, and the rest over twice the root gives 10 bits
 * more: q < 2^16, |rest| < 2^21, r <= 2^16. */
static inline uint32_t root_of(uint32_t n)
{
    const uint32_t x = n >> 16;
    uint32_t r = ((uint32_t)first_guess[(n >> 25) - 32] + 128) << 8;
    const int32_t e = (int32_t)((UINT32_C(1) << 30) - (x * r >> 16) * r);
    r += (uint32_t)((e >> 15) * (int32_t)r >> 16);
    const uint32_t q = x * r >> 15;
    const int32_t rest = (int32_t)(n - q * q);
    return (q << 10) + (uint32_t)((rest >> 4) * (int32_t)(r >> 2) >> 16);
}

/* radius^2 - distance^2 in 32 bits, of 2^-16 px^2 times 4^-down. */
static uint32_t square_at(const struct pel_smooth_circle *c, int32_t distance,
                          int32_t *down)
{
    uint64_t n = (uint64_t)(pel_square(c->radius) - pel_square(distance));
    for (; n >> 32; n >>= 2)
        ++*down;
    return (uint32_t)n;
}

int32_t pel_smooth_arc_at(const struct pel_smooth_circle *c, int32_t distance,
                          bool down)
{
    if (c->down == PEL_SMOOTH_OVAL)
        return c->of.oval->at(c->of.oval, distance, down);
    const uint32_t r = (uint32_t)c->radius, d = (uint32_t)distance;
    int32_t shift = 0;
    if (distance >= c->radius)
        return 0;
    uint32_t n = r < 65536 ? r * r - d * d : square_at(c, distance, &shift);
    for (; n < UINT32_C(1) << 30; n <<= 2)
        shift--;
    const uint32_t root = root_of(n);
    return (int32_t)(shift < 2 ? root >> (2 - shift) : root << (shift - 2));
}

void pel_smooth_circle_set(struct pel_smooth_circle *c, int32_t radius)
{
    const uint32_t r = (uint32_t)pel_max(radius, 1);
    c->radius = radius;
    c->reach = radius * 256;
    c->down = c->first = 0;
    c->count = 4;
    c->hole = false;
    while (r >> c->down >= SMALL)
        c->down++;
    c->of.inverse = pel_divide(UINT32_C(1) << (20 + c->down), r);
}

/* The step is taken with 16 bits, and the rise with as many. A line that moves
 * less than 2^-16 px in a row is taken as one that moves so far. */
struct pel_smooth_slope pel_smooth_slope_of(uint64_t step)
{
    struct pel_smooth_slope slope;
    int shift = 1;
    while (step >> shift > 65535)
        shift++;
    const int32_t m = pel_max((int32_t)(step >> shift), 32768);
    slope.rise = pel_divide(UINT64_C(1) << 31, (uint32_t)m);
    slope.up = (uint8_t)pel_max(16 - shift, 0);
    slope.down = (uint8_t)pel_max(shift - 16, 0);
    return slope;
}

/* The area between an arc and its chord of length l is
 *     l^3 / 12 r (1 + 3/10 q^2 + 9/56 q^4 ..), q = l / 2 r.
 * Below 40 px of radius l = (du v + dv u) / (r sqrt(1 - q^2)), with (u, v) the
 * chord's middle, since the chord is at a right angle to the radius there. With
 * r alone for that divisor the sum is 1.71 at most, for a quarter of a circle;
 * the cubic is off by .0012 of it. du, dv in 2^-11 px, u and v in 2^-10 px: the
 * products are below 2^11.5 2^8 r 2^12 / r, then 2^31. In 2^-15 px. */
static uint32_t small_bulge(const struct pel_smooth_circle *c,
                            const struct pel_smooth_arc_piece *p)
{
    const uint32_t du = (uint32_t)(p->u1 - p->u0) >> 5;
    const uint32_t dv = (uint32_t)(p->v0 - p->v1) >> 5;
    const uint32_t u = ((uint32_t)p->u0 + (uint32_t)p->u1) >> 7;
    const uint32_t v = ((uint32_t)p->v0 + (uint32_t)p->v1) >> 7;
    const uint32_t square = du * du + dv * dv;
    const uint32_t length = ((du * v + dv * u) >> 2) * c->of.inverse >> 20;
    const uint32_t three = ((square >> 4) * length >> 14) * c->of.inverse >> 14;
    const uint32_t area = three * 21845 >> 16;
    const uint32_t k = c->of.inverse >> 3;
    const uint32_t q = (square >> 6) * (k * k >> 4) >> 16;
    uint32_t more = 15469 + (120567 * q >> 16);
    more = 55255 + (more * q >> 16);
    return area + (area * (more * q >> 16) >> 16);
}

/* From 40 px on l is what a piece has along the axis that the strip's arc goes
 * along, times r / z, z the distance from the centre along the other one, at
 * the middle of the strip: at least .69 r. */
static inline bool is_steep(const struct pel_smooth_strip *s)
{
    return s->at_near - s->at_far < s->far - s->near;
}

/* (r / z)^3 / 12 r, 2^-23 px, by twice z: the area of a piece that goes along
 * the axis for a pixel, below .006 px. With z = (1 - e) r, 4/3 (1 - e)^-3 is a
 * polynomial that is off by 2.3 %, and the middle of the strip for that of the
 * piece by 5 %, where r is 40 px: together by .1 of 255. The factors are below
 * 2^14 2^8, 2^8 2^11, 2^9 2^8. */
static inline uint32_t pixel_bulge(const struct pel_smooth_circle *c,
                                   uint32_t z)
{
    const uint32_t e =
        (((uint32_t)c->radius - (z >> 9)) >> c->down) * c->of.inverse >> 8;
    const uint32_t p = 173 + ((169 + (19 * e >> 6)) * e >> 11);
    return p * c->of.inverse >> c->down;
}

/* Of a piece that goes along it for w, at most 2^16: below 2^16 2^15. */
static inline uint32_t large_bulge(uint32_t pixel, int32_t w)
{
    const uint32_t half = (uint32_t)w >> 1, square = half * half >> 15;
    return pixel * (square * half >> 15) >> 23;
}

static uint32_t bulge_of(const struct pel_smooth_strip *s,
                         const struct pel_smooth_arc_piece *p)
{
    const struct pel_smooth_circle *const c = s->circle;
    if (c->down == PEL_SMOOTH_OVAL)
        return c->of.oval->bulge(c->of.oval, p);
    if (c->down == 0)
        return small_bulge(c, p);
    uint32_t z = (uint32_t)s->near + (uint32_t)s->far;
    int32_t w = p->u1 - p->u0;
    if (is_steep(s)) {
        z = (uint32_t)s->at_near + (uint32_t)s->at_far;
        w = p->v0 - p->v1;
    }
    return large_bulge(pixel_bulge(c, z), w);
}

/* What lies below a piece's chord and above the strip's near end, 2^-15 px: the
 * factors are at most 2^15 and 2^16. */
static inline uint32_t chord_area(const struct pel_smooth_strip *s,
                                  const struct pel_smooth_arc_piece *p)
{
    const uint32_t w = (uint32_t)(p->u1 - p->u0);
    const uint32_t h = (uint32_t)(p->v0 - s->near + p->v1 - s->near);
    return (w >> 1) * (h >> 1) >> 16;
}

/* The height of a line at a column's boundary: the product is below 2^32. */
static inline int32_t line_at(const struct pel_smooth_strip *s, int32_t u)
{
    const uint32_t way = (uint32_t)(u - s->at_far);
    const uint32_t moved = way << s->slope.up >> s->slope.down;
    return s->far - (int32_t)(moved * s->slope.rise >> 15);
}

/* The height of the arc at a column's boundary, in the strip. */
static inline int32_t height_at(const struct pel_smooth_strip *s, int32_t u)
{
    const int32_t v =
        s->circle ? pel_smooth_arc_at(s->circle, u >> 8, true) : line_at(s, u);
    return pel_max(s->near, pel_min(v, s->far));
}

void pel_smooth_go_on(const struct pel_smooth_strip *s, int32_t u,
                      struct pel_smooth_arc_piece *p)
{
    if (p->u1 != u && u > s->at_far)
        p->v1 = height_at(s, u);
    p->u0 = pel_max(u, s->at_far);
    p->v0 = u > s->at_far ? p->v1 : s->far;
    p->u1 = pel_min(u + 65536, s->at_near);
    p->v1 = p->u1 == s->at_near ? s->near : height_at(s, p->u1);
}

uint32_t pel_smooth_area(const struct pel_smooth_strip *s, int32_t u,
                         const struct pel_smooth_arc_piece *p)
{
    const uint32_t whole = (uint32_t)(p->u0 - u) >> 1;
    const uint32_t area =
        (whole * (uint32_t)(s->far - s->near) >> 16) + chord_area(s, p);
    return s->circle ? area + bulge_of(s, p) : area;
}

#if !PEL_SMOOTH_TINY
/* Is it a circle that cover_arc takes? */
static inline bool is_large(const struct pel_smooth_circle *c)
{
    return c && c->down > 0 && c->down != PEL_SMOOTH_OVAL && c->radius < 65536;
}

/* Of all that a strip has of a circle. */
static PEL_NOINLINE uint32_t all_bulge(const struct pel_smooth_strip *s)
{
    const struct pel_smooth_arc_piece all = {s->at_far, s->far, s->at_near,
                                             s->near};
    return bulge_of(s, &all);
}

static inline void put_area(uint32_t area, uint32_t flip, uint8_t *to)
{
    *to = pel_smooth_coverage((area ^ flip) + (flip & 32769));
}

/* Columns from u on, of which the side leaves the first one; of lines, or of
 * all kinds. */
static PEL_ALWAYS_INLINE void cover_columns(const struct pel_smooth_side *k,
                                            int32_t u, uint32_t flip,
                                            uint8_t *to, bool line)
{
    const struct pel_smooth_strip *const s = k->strip;
    const int32_t step = k->left ? -1 : 1, near = s->near, last = s->at_near;
    uint32_t whole = (uint32_t)(s->at_far - u) >> 1;
    int32_t u0 = s->at_far, v0 = s->far;
    for (int32_t n = k->bytes; n > 0; n--, to += step) {
        u += 65536;
        const int32_t u1 = pel_min(u, last);
        const int32_t v1 = u >= last ? near
                           : line    ? pel_max(near, line_at(s, u))
                                     : height_at(s, u);
        const struct pel_smooth_arc_piece p = {u0, v0, u1, v1};
        put_area(whole + chord_area(s, &p) + (line ? 0 : bulge_of(s, &p)), flip,
                 to);
        u0 = u1;
        v0 = v1;
        whole = 0;
    }
}

static PEL_NOINLINE void cover_line(const struct pel_smooth_side *k, int32_t u,
                                    uint32_t flip, uint8_t *to)
{
    cover_columns(k, u, flip, to, true);
}

static PEL_NOINLINE void cover_any(const struct pel_smooth_side *k, int32_t u,
                                   uint32_t flip, uint8_t *to)
{
    cover_columns(k, u, flip, to, false);
}

/* The height of the arc of a circle whose square has 32 bits, in its strip.
 * Roots further out need no smaller shift. */
static PEL_ALWAYS_INLINE int32_t arc_height(const struct pel_smooth_strip *s,
                                            uint32_t square, int32_t u,
                                            int32_t *shift)
{
    const uint32_t d = (uint32_t)u >> 8;
    uint32_t n = (square - d * d) << *shift;
    for (; n < UINT32_C(1) << 30; n <<= 2)
        *shift += 2;
    const int32_t v = (int32_t)(root_of(n) >> (2 + (*shift >> 1))) - s->near;
    return pel_max(0, pel_min(v, s->far - s->near));
}

/* The area below a piece of it that goes along for w and down from v0 to v1. */
static inline uint32_t piece_area(const struct pel_smooth_strip *s, int32_t w,
                                  int32_t v0, int32_t v1)
{
    return ((uint32_t)(w >> 1) * ((uint32_t)(v0 + v1) >> 1) >> 16) +
           large_bulge(s->bulge, is_steep(s) ? v0 - v1 : w);
}

/* The same of such a circle, two columns or more: a part of the first one,
 * whole ones, a part of the last one. */
static PEL_NOINLINE void cover_arc(const struct pel_smooth_side *k, int32_t u,
                                   uint32_t flip, uint8_t *to)
{
    const struct pel_smooth_strip *const s = k->strip;
    const int32_t step = k->left ? -1 : 1, w = u + 65536 - s->at_far;
    const uint32_t r = (uint32_t)s->circle->radius, square = r * r;
    const uint8_t *const last = to + (k->bytes - 1) * step;
    int32_t shift = 0, v0 = arc_height(s, square, u += 65536, &shift);
    put_area(((uint32_t)(65536 - w) >> 1) +
                 piece_area(s, w, s->far - s->near, v0),
             flip, to);
    for (; u + 65536 < s->at_near; u += 65536) {
        const int32_t v1 = arc_height(s, square, u + 65536, &shift);
        put_area(((uint32_t)(v0 + v1) >> 2) + (s->bulge >> 8), flip,
                 to += step);
        v0 = v1;
    }
    put_area(piece_area(s, s->at_near - u, v0, 0), flip, to += step);
    if (to != last)
        put_area(0, flip, to + step);
}

void pel_smooth_side_cover(const struct pel_smooth_side *k, uint8_t *to)
{
    const struct pel_smooth_strip *const s = k->strip;
    const uint32_t flip = k->flip;
    const int32_t u = k->u;
    if (k->left)
        to += k->bytes - 1;
    if (s->at_near - u > 65536) {
        if (s->bulge)
            cover_arc(k, u, flip, to);
        else if (s->circle)
            cover_any(k, u, flip, to);
        else
            cover_line(k, u, flip, to);
        return;
    }
    uint32_t area = ((uint32_t)(s->at_far - u) >> 1) +
                    ((uint32_t)(s->at_near - s->at_far) >> 2) + (s->bulge >> 8);
    if (s->circle && s->bulge == 0)
        area += all_bulge(s);
    put_area(area, flip, to);
    if (k->bytes > 1)
        put_area(0, flip, to + (k->left ? -1 : 1));
}

uint32_t pel_smooth_pixel_bulge(const struct pel_smooth_strip *s)
{
    const bool steep = is_steep(s);
    return pixel_bulge(s->circle, (uint32_t)(steep ? s->at_near : s->near) +
                                      (uint32_t)(steep ? s->at_far : s->far));
}

void pel_smooth_strip_begin(struct pel_smooth_strip *s)
{
    s->bulge = is_large(s->circle) ? pel_smooth_pixel_bulge(s) : 0;
}
#endif
