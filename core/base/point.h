/* Sub-pixel coordinates. Pixel (x, y) covers [x, x+1) x [y, y+1), its centre
 * lies at (x + 1/2, y + 1/2), y grows downwards. Vertices are whole numbers of
 * 1/256 px, from -32,768 px up to and including 32,767 + 255/256 px: so a
 * difference of two fits 25 bits with its sign. */
#ifndef PEL_BASE_POINT_H
#define PEL_BASE_POINT_H

#include <stdbool.h>
#include <stdint.h>

#include "multiply.h"

PEL_BEGIN_DECLS

#define PEL_COORDINATE_MIN INT32_C(-8388608)
#define PEL_COORDINATE_MAX INT32_C(8388607)

/* n pixels, -32,768 to 32,767, in sub-pixels, for constant expressions too. A
 * constant may have a fraction, PEL_PX(7.5), and compiles to a whole number of
 * sub-pixels: what is left is cut off. */
#define PEL_PX(n) PEL_CAST(int32_t, (n)*INT64_C(256))

struct pel_point {
    int32_t x, y; /* 1/256 px */
};

/* A point from pixels: PEL_AT initialises one, pel_at is one, in a call. */
#define PEL_AT(x, y)         \
    {                        \
        PEL_PX(x), PEL_PX(y) \
    }
#define pel_at(x, y) pel_point_of(PEL_PX(x), PEL_PX(y))

static inline struct pel_point pel_point_of(int32_t x, int32_t y)
{
    const struct pel_point p = {x, y};
    return p;
}

/* Core shifts negative numbers to the right and expects the floor, which C
 * leaves to the compiler. */
typedef char pel_shift_is_arithmetic[((-3) >> 1) == -2 ? 1 : -1];

/* Sums of sub-pixels are of type int. */
typedef char pel_int_has_32_bits[sizeof(int) >= 4 ? 1 : -1];

/* Pixel that holds a sub-pixel coordinate. */
static inline int32_t pel_pixel_of(int32_t v)
{
    return v >> 8;
}

/* First pixel whose centre lies at or after v: ceil((v - 128) / 256). */
static inline int32_t pel_first_pixel(int32_t v)
{
    return (v + 127) >> 8;
}

/* Centre of pixel i; |i| < 2^23. */
static inline int32_t pel_pixel_center(int32_t i)
{
    return i * 256 + 128;
}

static inline int32_t pel_min(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static inline int32_t pel_max(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

static inline int32_t pel_magnitude(int32_t v)
{
    return v < 0 ? -v : v;
}

/* The one of pixels a to b - 1 that is the nearest to a coordinate, or the
 * farthest. */
static inline int32_t pel_nearest_pixel(int32_t a, int32_t b, int32_t v)
{
    return pel_max(a, pel_min(pel_pixel_of(v), b - 1));
}

static inline int32_t pel_farthest_pixel(int32_t a, int32_t b, int32_t v)
{
    return v - pel_pixel_center(a) > pel_pixel_center(b - 1) - v ? a : b - 1;
}

/* Legal coordinates plus 2^23 fit 24 bits: no bit above is set in either. */
static inline uint32_t pel_point_offset(struct pel_point p)
{
    return (PEL_CAST(uint32_t, p.x) + 0x800000u) |
           (PEL_CAST(uint32_t, p.y) + 0x800000u);
}

/* Is the point in range? */
static inline bool pel_point_legal(struct pel_point p)
{
    return pel_point_offset(p) >> 24 == 0;
}

/* Are all n points in range? */
static inline bool pel_points_legal(const struct pel_point *v, int32_t n)
{
    while (n-- > 0)
        if (!pel_point_legal(v[n]))
            return false;
    return true;
}

/* Are a triangle's corners? A loop takes 24 instructions more on an M0+. */
static inline bool pel_corners_legal(const struct pel_point v[3])
{
    const uint32_t offset = pel_point_offset(v[0]) | pel_point_offset(v[1]) |
                            pel_point_offset(v[2]);
    return PEL_SMALL_CODE ? pel_points_legal(v, 3) : offset >> 24 == 0;
}

/* Twice a triangle's area in 1/65,536 px^2, below 2^50: above 0 where its three
 * legal corners run clockwise on screen. */
static PEL_SHARED int64_t pel_corners_area(const struct pel_point *v)
{
    return pel_product(v[1].x - v[0].x, v[2].y - v[0].y) -
           pel_product(v[2].x - v[0].x, v[1].y - v[0].y);
}

/* For PEL_HINT: false when all of n points and a radius (or 0) are below 2 px
 * and not all are 0, as pixels are that are meant to be sub-pixels. */
static inline bool pel_in_subpixels(const struct pel_point *v, int32_t n,
                                    int32_t radius)
{
    uint32_t all = PEL_CAST(uint32_t, radius);
    while (n-- > 0)
        all |= PEL_CAST(uint32_t, v[n].x) | PEL_CAST(uint32_t, v[n].y);
    return all - 1 >= 511;
}

/* Can pixel (x, y) be one of a surface? */
static inline bool pel_pixel_legal(int32_t x, int32_t y)
{
    const uint32_t a = PEL_CAST(uint32_t, x) + 32768u;
    const uint32_t b = PEL_CAST(uint32_t, y) + 32768u;
    return (a | b) >> 16 == 0;
}

/* Where a picture or text goes, px: -65,536..65,536. */
static inline bool pel_offset_legal(int32_t x, int32_t y)
{
    return x >= -65536 && x <= 65536 && y >= -65536 && y <= 65536;
}

/* A radius in sub-pixels: 0..32,767 px. */
static inline bool pel_radius_legal(int32_t radius)
{
    return radius >= 0 && radius <= PEL_PX(32767);
}
PEL_END_DECLS
#endif
