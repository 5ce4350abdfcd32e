#include "gouraud.h"

#include "../base/divide.h"
#include "plane.h"

/* A step of one pixel in 8.24 is a gradient times 2^32. One reciprocal,
 * `inverse` = 2^(31 + bits) / area, serves all channels where it is close
 * enough; elsewhere, in large or very thin triangles, it is 0, and a long
 * division is exact. */

/* The reciprocal is good to 2^-30 of its value: 2^-31 by its own last bit, as
 * much by the area's, if it had to be cut to 32 bits. A numerator is the
 * difference of two products, each of two values' difference, at most 255, and
 * two coordinates', at most D, the longer side of the box: |n| <= 510 D. With
 * area >= 16 D a gradient is at most 510 D 2^32 / 16 D < 2^37, and so off by
 * less than 2^7 steps of 2^-24: 2^-17 per pixel, the bound of the header. With
 * D <= 2^20 (4,096 px) that is 2^-4 at most, and a numerator, below 2^29, times
 * the reciprocal, at most 2^32, fits 2^61. */
static bool reciprocal_is_enough(const struct pel_point v[3], uint64_t area)
{
    const struct pel_rect box = pel_corners_box(v);
    const int32_t longer = pel_max(box.x1 - box.x0, box.y1 - box.y0);
    return longer <= 1048576 && area >= (uint64_t)longer * 16;
}

/* False: no area. */
static bool start(struct pel_plane_setup *s, const struct pel_point v[3])
{
    pel_plane_corners(s, v);
    s->inverse = 0;
    s->bits = (uint8_t)pel_bits_of(s->area);
    if (s->area == 0 || !reciprocal_is_enough(v, s->area))
        return s->area != 0;
    const uint32_t word = (uint32_t)(s->area << (64 - s->bits) >> 32);
    s->inverse = UINT64_C(1) << 32;
    if (word > UINT32_C(0x80000000))
        s->inverse = pel_divide(UINT64_C(1) << 63, word);
    return true;
}

/* n 2^32 / area modulo 2^64: rounded down, or by long division towards zero. */
static PEL_INLINE_64 uint64_t gradient_of(const struct pel_plane_setup *s,
                                          int64_t n)
{
    uint64_t fine;
    if (s->inverse)
        return (uint64_t)(n * (int64_t)s->inverse >> (s->bits - 1));
    const uint64_t q =
        pel_divide_fraction((uint64_t)pel_size_of(n), s->area, &fine);
    return n < 0 ? 0 - q : q;
}

static inline int32_t channel_of(pel_color color, int k)
{
    return (int32_t)(color >> 8 * k & 255);
}

/* Sets channel k from the colors at the vertices: the value at a plus the
 * gradients times the way from a to the centre of pixel (0, 0). Bits 8..39 of
 * `sum` are the 32 bits of 8.24, and are right modulo 2^64. */
static PEL_INLINE_64 void set_channel(struct pel_gouraud *p,
                                      const struct pel_plane_setup *s, int k,
                                      const pel_color color[3])
{
    const int32_t b = channel_of(color[1], k) - channel_of(color[0], k);
    const int32_t c = channel_of(color[2], k) - channel_of(color[0], k);
    const uint64_t gx = gradient_of(s, pel_product(b, s->right[1]) +
                                           pel_product(c, s->right[2]));
    const uint64_t gy =
        gradient_of(s, pel_product(b, s->down[1]) + pel_product(c, s->down[2]));
    const uint64_t sum =
        pel_times(gx, 128 - s->a.x) + pel_times(gy, 128 - s->a.y);
    p->dx[k] = (uint32_t)gx;
    p->dy[k] = (uint32_t)gy;
    p->at[k] += (uint32_t)(sum >> 8);
}

enum pel_status pel_gouraud_init(struct pel_gouraud *paint,
                                 const struct pel_point v[3],
                                 const pel_color c[3])
{
    if (paint)
        pel_paint_clear(&paint->paint);
    if (!paint || !v || !c)
        return PEL_ERROR_NULL;
    if (!pel_corners_legal(v))
        return PEL_ERROR_RANGE;
    struct pel_plane_setup s;
    const bool opaque = pel_alpha(c[0] & c[1] & c[2]) == 255;
    paint->paint = (struct pel_paint){pel_gouraud_fill, NULL};
    const bool has_area = start(&s, v);
    for (int k = 0; k < 4; k++) {
        paint->at[k] = (c[s.first] >> 8 * k << 24) + 0x800000u;
        paint->dx[k] = 0;
        paint->dy[k] = 0;
    }
    if (!has_area)
        return PEL_OK;
    set_channel(paint, &s, 0, c);
    set_channel(paint, &s, 1, c);
    set_channel(paint, &s, 2, c);
    if (!opaque)
        set_channel(paint, &s, 3, c);
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
