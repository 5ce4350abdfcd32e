/* Planes: values that are linear over a triangle, such as colors, texels and
 * depths. */
#ifndef PEL_RASTER_PLANE_H
#define PEL_RASTER_PLANE_H

#include "../base/point.h"

PEL_BEGIN_DECLS

/* The value at the centre of pixel (x, y): at + x dx + y dy, modulo 2^64 and in
 * two's complement. Only values inside the triangle must fit: gradients may
 * wrap, so slivers need no special case. */
struct pel_plane {
    uint64_t at, dx, dy;
};

/* What all planes of a triangle share. The gradient of values at the vertices
 * is pel_dot(value, right) / area for each sub-pixel to the right, with `down`
 * for each one down. */
struct pel_plane_setup {
    struct pel_point a; /* the topmost vertex: planes start there */
    uint8_t first;      /* its index */
    uint8_t bits;       /* of the area, where there is an inverse */
    int32_t right[3], down[3];
    uint64_t area;    /* twice the triangle's; 0: both gradients are 0 */
    uint64_t inverse; /* of it, 2^-(bits + 62), where CPUs use it */
};

/* Sets it for legal vertices. False: no area. */
bool pel_plane_start(struct pel_plane_setup *setup,
                     const struct pel_point v[3]);

/* Sets all but the inverse, for those who divide by other means. */
void pel_plane_corners(struct pel_plane_setup *setup,
                       const struct pel_point v[3]);

/* The plane, in 2^-24, with value[i] at v[i]. At pixels inside the triangle it
 * is off by less than 2^-6, and when the triangle is thinner than 1/256 px by
 * less than 2^-17 of the largest value. The order of the vertices does not
 * matter. */
void pel_plane_set(struct pel_plane *plane, const struct pel_plane_setup *setup,
                   const int32_t value[3]);

/* The value at (x, y). */
#if PEL_64BIT
static inline uint64_t pel_plane_at(const struct pel_plane *p, int32_t x,
                                    int32_t y)
{
    return p->at + pel_times(p->dx, x) + pel_times(p->dy, y);
}
#else
uint64_t pel_plane_at(const struct pel_plane *p, int32_t x, int32_t y);
#endif

/* The whole part of a value in 2^-24; it must fit. */
static inline int32_t pel_plane_whole(uint64_t value)
{
    return PEL_CAST(int32_t, PEL_CAST(int64_t, value) >> 24);
}
PEL_END_DECLS
#endif
