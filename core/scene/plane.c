#include "plane.h"

#include "../raster/triangle_sort.h"
#include "vector.h"

/* The upper and the lower half of a b. */
static uint64_t multiply(uint64_t a, uint64_t b, uint64_t *low)
{
    const uint64_t al = a & 0xFFFFFFFFu, ah = a >> 32;
    const uint64_t bl = b & 0xFFFFFFFFu, bh = b >> 32;
    const uint64_t cross = ah * bl + (al * bl >> 32);
    const uint64_t other = al * bh + (cross & 0xFFFFFFFFu);
    *low = a * b;
    return ah * bh + (cross >> 32) + (other >> 32);
}

/* word = area 2^(63 - bits), in [2^62, 2^63). r = 2^63 / (word >> 31) is right
 * to 2^-31, so word r 2^-31 misses 2^63 by less than 2^33; what it misses, by
 * Newton, makes r right to 2^-59. */
static void invert(struct pel_plane_setup *s)
{
    const int bits = pel_bits_of(s->area);
    const uint64_t word = s->area << (63 - bits);
    const uint64_t r = (UINT64_C(1) << 63) / (word >> 31);
    const uint64_t near =
        (word >> 32) * r * 2 + ((word & 0xFFFFFFFFu) * r >> 31);
    const int64_t miss = (int64_t)((UINT64_C(1) << 63) - near) >> 3;
    s->inverse = (r << 31) + (uint64_t)((int64_t)r * miss >> 29);
    s->shift = (uint8_t)(30 + bits);
}

bool pel_plane_start(struct pel_plane_setup *setup, const struct pel_point v[3])
{
    const struct pel_point *p[3] = {&v[0], &v[1], &v[2]};
    struct pel_plane_setup *s = setup;
    pel_sort3(p);
    const struct pel_point *a = p[0], *b = p[1], *c = p[2];
    int64_t area = (int64_t)(b->x - a->x) * (c->y - a->y) -
                   (int64_t)(c->x - a->x) * (b->y - a->y);
    if (area < 0) {
        pel_swap_points(&b, &c);
        area = -area;
    }
    s->a = *a;
    s->ab = (struct pel_point){b->x - a->x, b->y - a->y};
    s->ac = (struct pel_point){c->x - a->x, c->y - a->y};
    s->first = (uint8_t)(a - v);
    s->second = (uint8_t)(b - v);
    s->third = (uint8_t)(c - v);
    s->area = (uint64_t)area;
    if (area)
        invert(s);
    return area != 0;
}

/* The gradient n / area: of a sub-pixel in 2^-24, and of a pixel. 128 bits of n
 * times the inverse, 2^-(shift + 32) of which is the second one. */
static void gradient(const struct pel_plane_setup *s, int64_t n,
                     uint64_t *subpixel, uint64_t *pixel)
{
    uint64_t low, high = multiply((uint64_t)pel_size_of(n), s->inverse, &low);
    int shift = s->shift;
    if (shift >= 64) {
        low = high;
        high = 0;
        shift -= 64;
    }
    low = low >> shift | high << 1 << (63 - shift);
    high >>= shift;
    *pixel = n < 0 ? 0 - low : low;
    low = low >> 8 | high << 56;
    *subpixel = n < 0 ? 0 - low : low;
}

/* With nx = (vb - va) ac.y - (vc - va) ab.y, below 2^58, the gradient is nx /
 * area; in y alike. The anchor is the pixel of a, whose centre is up to 128
 * sub-pixels away. From there a step of a pixel has eight bits more, which keep
 * the longest way right to 2^16 2^-24. */
void pel_plane_set(struct pel_plane *plane, const struct pel_plane_setup *setup,
                   const int32_t value[3])
{
    const struct pel_plane_setup *s = setup;
    const int32_t top = value[s->first];
    const int64_t b = (int64_t)value[s->second] - top;
    const int64_t c = (int64_t)value[s->third] - top;
    const int32_t x = pel_pixel_of(s->a.x), y = pel_pixel_of(s->a.y);
    uint64_t gx, gy;
    *plane = pel_plane_level(top);
    if (b == 0 && c == 0)
        return;
    gradient(s, b * s->ac.y - c * s->ab.y, &gx, &plane->dx);
    gradient(s, c * s->ab.x - b * s->ac.x, &gy, &plane->dy);
    plane->at += gx * (uint64_t)(int64_t)(pel_pixel_center(x) - s->a.x) +
                 gy * (uint64_t)(int64_t)(pel_pixel_center(y) - s->a.y) -
                 (uint64_t)(int64_t)x * plane->dx -
                 (uint64_t)(int64_t)y * plane->dy;
}
