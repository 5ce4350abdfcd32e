#include "strip.h"

#include "../base/divide.h"
#include "smooth.h"
#include "strip_arc.h"

#include <stddef.h>

/* Radii are seen in half the size until they are below this. */
enum { SMALL = 40 * 256 };

/* 2^23 / sqrt((i + 32.5) 2^25) - 128 */
const uint8_t pel_smooth_first_guess[96] = {
    126, 122, 119, 115, 112, 108, 105, 102, 100, 97, 94, 92, 89, 87, 84, 82,
    80,  78,  76,  74,  72,  70,  68,  66,  65,  63, 61, 60, 58, 57, 55, 54,
    52,  51,  50,  48,  47,  46,  44,  43,  42,  41, 40, 39, 38, 36, 35, 34,
    33,  32,  31,  30,  30,  29,  28,  27,  26,  25, 24, 23, 23, 22, 21, 20,
    19,  19,  18,  17,  16,  16,  15,  14,  14,  13, 12, 12, 11, 10, 10, 9,
    9,   8,   7,   7,   6,   6,   5,   4,   4,   3,  3,  2,  2,  1,  1,  0,
};

/* radius^2 - distance^2 in 32 bits, of 2^-16 px^2 times 4^-down. */
static uint32_t square_at(const struct pel_smooth_circle *c, int32_t distance,
                          int32_t *down)
{
    uint64_t n = (uint64_t)(pel_square(c->radius) - pel_square(distance));
    for (; n >> 32; n >>= 2)
        ++*down;
    return (uint32_t)n;
}

int32_t pel_smooth_reach(const struct pel_smooth_circle *c)
{
    return c->down == PEL_SMOOTH_OVAL ? c->of.oval->at(c->of.oval, 0, false)
                                      : c->radius * 256;
}

static PEL_SMOOTH_APART int32_t circle_at(const struct pel_smooth_circle *c,
                                          int32_t distance)
{
    const uint32_t r = (uint32_t)c->radius, d = (uint32_t)distance;
    int32_t shift = 0;
    if (distance >= c->radius)
        return 0;
    uint32_t n = r < 65536 ? r * r - d * d : square_at(c, distance, &shift);
    for (; n < UINT32_C(1) << 30; n <<= 2)
        shift--;
    const uint32_t root = pel_smooth_root(n);
    return (int32_t)(shift < 2 ? root >> (2 - shift) : root << (shift - 2));
}

int32_t pel_smooth_arc_at(const struct pel_smooth_circle *c, int32_t distance,
                          bool down)
{
    if (c->down == PEL_SMOOTH_OVAL)
        return c->of.oval->at(c->of.oval, distance, down);
    return circle_at(c, distance);
}

void pel_smooth_circle_begin(struct pel_smooth_circle *c, int32_t radius)
{
    c->radius = radius;
    c->down = c->first = 0;
    c->count = 4;
    c->hole = false;
    while (radius >> c->down >= SMALL)
        c->down++;
}

void pel_smooth_circle_set(struct pel_smooth_circle *c, int32_t radius)
{
    pel_smooth_circle_begin(c, radius);
    c->of.inverse =
        pel_divide(UINT32_C(1) << (20 + c->down), (uint32_t)pel_max(radius, 1));
}

uint32_t pel_smooth_circle_inverse(int32_t radius)
{
    struct pel_smooth_circle circle;
    pel_smooth_circle_set(&circle, radius);
    return circle.of.inverse;
}

/* The step is taken with 16 bits, and the rise with as many. A line that moves
 * less than 2^-16 px in a row is taken as one that moves so far. */
void pel_smooth_slope_set(struct pel_smooth_slope *slope, uint64_t step)
{
    int shift = 1;
    while (step >> shift > 65535)
        shift++;
    const int32_t m = pel_max((int32_t)(step >> shift), 32768);
    slope->rise = pel_divide(UINT64_C(1) << 31, (uint32_t)m);
    slope->up = (uint8_t)pel_max(16 - shift, 0);
    slope->down = (uint8_t)pel_max(shift - 16, 0);
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
    if (pel_smooth_is_steep(s)) {
        z = (uint32_t)s->at_near + (uint32_t)s->at_far;
        w = p->v0 - p->v1;
    }
    return pel_smooth_large_bulge(pel_smooth_pixel_bulge(c, z), w);
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

/* The column's outer boundary, or where the arc ends in it. */
static inline int32_t next_boundary(const struct pel_smooth_strip *s, int32_t u)
{
    return (uint32_t)s->at_near - (uint32_t)u <= 65536 ? s->at_near : u + 65536;
}

void pel_smooth_go_on(const struct pel_smooth_strip *s, int32_t u,
                      struct pel_smooth_arc_piece *p)
{
    if (p->u1 != u && u > s->at_far)
        p->v1 = height_at(s, u);
    p->u0 = pel_max(u, s->at_far);
    p->v0 = u > s->at_far ? p->v1 : s->far;
    p->u1 = next_boundary(s, u);
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
/* Of all that a strip has of a circle. */
static PEL_NOINLINE uint32_t all_bulge(const struct pel_smooth_strip *s)
{
    const struct pel_smooth_arc_piece all = {s->at_far, s->far, s->at_near,
                                             s->near};
    return bulge_of(s, &all);
}

static PEL_ALWAYS_INLINE void put_area(uint32_t area,
                                       const struct pel_smooth_side *k,
                                       uint8_t *to)
{
    *to = pel_smooth_coverage_of((area ^ k->flip) + k->more);
}

/* Columns of any kind of side, which leaves the first one at u. */
static PEL_NOINLINE void cover_any(const struct pel_smooth_side *k, int32_t u,
                                   uint8_t *to)
{
    const struct pel_smooth_strip *const s = k->strip;
    const int32_t step = k->step;
    uint32_t whole = (uint32_t)(s->at_far - u) >> 1;
    int32_t u0 = s->at_far, v0 = s->far;
    for (int32_t n = k->bytes; n > 0; n--, to += step) {
        const int32_t u1 = next_boundary(s, u);
        const int32_t v1 = u1 == s->at_near ? s->near : height_at(s, u1);
        const struct pel_smooth_arc_piece p = {u0, v0, u1, v1};
        put_area(whole + chord_area(s, &p) + bulge_of(s, &p), k, to);
        u = u0 = u1;
        v0 = v1;
        whole = 0;
    }
}

/* The height of the arc at a column's boundary, from the near end of its strip,
 * which is a row high; of a circle of 40 px or more. */
static PEL_ALWAYS_INLINE int32_t arc_height(const struct pel_smooth_strip *s,
                                            int32_t u)
{
    const int32_t v = pel_smooth_width_at(s->circle, u >> 8) - s->near;
    return pel_max(0, pel_min(v, 65536));
}

/* Both columns of such an arc that goes down more than along. */
static PEL_NOINLINE void cover_steep(const struct pel_smooth_side *k, int32_t u,
                                     uint8_t *to)
{
    const struct pel_smooth_strip *const s = k->strip;
    const int32_t end = s->at_near - u, w = u - s->at_far;
    const int32_t step = k->step;
    const int32_t v = arc_height(s, u);
    uint32_t area = (uint32_t)(65536 - w) >> 1;
    area += (uint32_t)(w >> 1) * ((uint32_t)(v + 65536) >> 1) >> 16;
    put_area(area + pel_smooth_large_bulge(s->bulge, 65536 - v), k, to);
    area = (uint32_t)(end >> 1) * ((uint32_t)v >> 1) >> 16;
    put_area(area + pel_smooth_large_bulge(s->bulge, v), k, to + step);
}

/* What is below a piece that goes along for w and down from v0 to v1. */
static PEL_ALWAYS_INLINE uint32_t piece_area(uint32_t bulge, int32_t w,
                                             int32_t v0, int32_t v1)
{
    return ((uint32_t)(w >> 1) * ((uint32_t)(v0 + v1) >> 1) >> 16) +
           pel_smooth_large_bulge(bulge, w);
}

/* Where a line is at boundaries of columns, in 2^-31 px from the far end. */
struct way {
    uint32_t moved, step;
};

static PEL_ALWAYS_INLINE int32_t line_height(struct way *way)
{
    const int32_t v = 65536 - (int32_t)(way->moved >> 15);
    way->moved += way->step;
    return pel_max(0, v);
}

/* Two columns or more, of a line or of such an arc that goes along more than
 * down: a part of the first one, whole ones, a part of the last one. The first
 * one ends at u. */
static PEL_ALWAYS_INLINE void cover_flat(const struct pel_smooth_side *k,
                                         int32_t u, uint8_t *to,
                                         struct way *way)
{
    const struct pel_smooth_strip *const s = k->strip;
    const int32_t end = s->at_near;
    const uint32_t bulge = way ? 0 : s->bulge;
    const int32_t w = u - s->at_far;
    int32_t v0 = way ? line_height(way) : arc_height(s, u);
    const uint32_t area = piece_area(bulge, w, 65536, v0);
    put_area(((uint32_t)(65536 - w) >> 1) + area, k, to);
    for (u += 65536; u < end; u += 65536) {
        const int32_t v1 = way ? line_height(way) : arc_height(s, u);
        put_area(((uint32_t)(v0 + v1) >> 2) + (bulge >> 8), k, to += k->step);
        v0 = v1;
    }
    put_area(piece_area(bulge, end - (u - 65536), v0, 0), k, to += k->step);
    if (u == end)
        put_area(0, k, to + k->step);
}

static PEL_NOINLINE void cover_arc(const struct pel_smooth_side *k, int32_t u,
                                   uint8_t *to)
{
    cover_flat(k, u, to, NULL);
}

/* A row with room for its bytes has fewer than 2^8 columns: their width is
 * shifted down by less than 16, and not up where there are three. */
static PEL_NOINLINE void cover_line(const struct pel_smooth_side *k, int32_t u,
                                    uint8_t *to)
{
    const struct pel_smooth_slope *const slope = &k->strip->slope;
    const uint32_t first = (uint32_t)(u - k->strip->at_far);
    struct way way = {(first << slope->up >> slope->down) * slope->rise,
                      (UINT32_C(65536) >> slope->down) * slope->rise};
    cover_flat(k, u, to, &way);
}

/* More than a column, of which the first one ends at u. */
static inline void cover_some(const struct pel_smooth_side *k, int32_t u,
                              uint8_t *to)
{
    const struct pel_smooth_strip *const s = k->strip;
    if (!s->circle)
        cover_line(k, u, to);
    else if (s->bulge == 0)
        cover_any(k, u - 65536, to);
    else if (pel_smooth_is_steep(s))
        cover_steep(k, u, to);
    else
        cover_arc(k, u, to);
}

void pel_smooth_side_cover(const struct pel_smooth_side *k, uint8_t *to)
{
    const struct pel_smooth_strip *const s = k->strip;
    const int32_t x = pel_smooth_column(k->center, s->at_far);
    const int32_t u = (x * 256 - k->center) * 256;
    if (k->step < 0)
        to += k->bytes - 1;
    if (s->at_near - u > 65536) {
        cover_some(k, u + 65536, to);
        return;
    }
    uint32_t area = ((uint32_t)(s->at_far - u) >> 1) +
                    ((uint32_t)(s->at_near - s->at_far) >> 2) + (s->bulge >> 8);
    if (s->circle && s->bulge == 0)
        area += all_bulge(s);
    put_area(area, k, to);
    if (k->bytes > 1)
        put_area(0, k, to + k->step);
}

#endif
