/* Planes: values that are linear over a triangle on screen. */
#ifndef PEL_SCENE_PLANE_H
#define PEL_SCENE_PLANE_H

#include "../base/point.h"

PEL_BEGIN_DECLS

/* At the centre of pixel (x, y): at + x dx + y dy, in 2^-24, modulo 2^64. Right
 * inside the triangle; gradients may wrap, so slivers need no special case. */
struct pel_plane {
    uint64_t at, dx, dy;
};

/* The part of the set-up that all planes of a triangle share. */
struct pel_plane_setup {
    struct pel_point a;      /* the topmost vertex */
    struct pel_point ab, ac; /* from it to the others */
    uint64_t area;           /* twice the triangle's */
    uint64_t inverse;        /* of it, 2^-(shift + 32), 63 bits */
    uint8_t shift;
    uint8_t first, second, third; /* indices of a and the others */
};

/* v is legal. One division. False: no area; planes must not be set. */
bool pel_plane_start(struct pel_plane_setup *setup,
                     const struct pel_point v[3]);

/* The plane with value[i] at v[i]; the values and their differences fit 32
 * bits. At pixels inside the triangle it is off by less than 2^-6, and when the
 * triangle is thinner than 1/256 px by less than 2^-17 of the largest value.
 * The order of the vertices does not matter. */
void pel_plane_set(struct pel_plane *plane, const struct pel_plane_setup *setup,
                   const int32_t value[3]);

/* The same value everywhere. */
static inline struct pel_plane pel_plane_level(int32_t value)
{
    struct pel_plane plane = {PEL_CAST(uint64_t, value) << 24, 0, 0};
    return plane;
}

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

/* The whole part of a value that fits. */
static inline int32_t pel_plane_whole(uint64_t value)
{
    return PEL_CAST(int32_t, PEL_CAST(int64_t, value) >> 24);
}
PEL_END_DECLS
#endif
