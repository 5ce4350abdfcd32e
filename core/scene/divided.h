/* Values in perspective: linear over a triangle in the world, so that they are
 * the quotients of two planes over the screen. One division serves all values
 * at a pixel, and they are linear in spans between two such pixels. */
#ifndef PEL_SCENE_DIVIDED_H
#define PEL_SCENE_DIVIDED_H

#include "../raster/plane.h"

PEL_BEGIN_DECLS

/* Pixels between divisions, a power of two; a span begins at a multiple of
 * it. */
enum {
    PEL_SPAN_EXACT = 1, /* a division at every pixel */
    PEL_SPAN_MAX = 64
};

/* The plane of (value - origin) w in 2^extent units 2^-8, so that its size is
 * at most that of w. */
struct pel_divided_value {
    struct pel_plane plane;
    int64_t origin;
    uint8_t extent;
};

/* The values of a triangle, and what they are divided by: w, which is
 * proportional to 1 / z and at most 2^30 inside the triangle. */
struct pel_divided {
    struct pel_plane w;
    struct pel_divided_value *value; /* the caller's, so many */
    uint8_t values;
    uint8_t span;      /* bits of it: 0..6 */
    int32_t corner[3]; /* w there */
};

/* All but the values. z[i]: the distance of corner i, in any unit, above 0.
 * span: above, or 0, which is 1; in triangles thinner than a pixel it is 1
 * always. The order of the corners does not matter. */
void pel_divided_init(struct pel_divided *divided,
                      const struct pel_plane_setup *setup, const int32_t z[3],
                      int32_t span);

/* corner[i]: the value at corner i, 2^-8 units, below 2^45 in size; differences
 * are below 2^39. */
void pel_divided_set(struct pel_divided_value *value,
                     const struct pel_divided *divided,
                     const struct pel_plane_setup *setup,
                     const int64_t corner[3]);

/* Sets at and dx of the planes of the values, 2^-24 units, in a row from pixel
 * (x, y) on, which is pixel (0, 0) of them, and returns for how many pixels
 * they hold: up to the end of the span, or one, where an end of it lies too far
 * outside of the triangle. At a divided pixel a value is right to 2^-28 of
 * 2^extent while the distances of the corners are within a ratio of 256.
 * Between two it is off by at most du (r - 1) / 4, du the change over the span,
 * r the ratio of the distances at its ends. */
int32_t pel_divided_lines(const struct pel_divided *divided, int32_t x,
                          int32_t y, struct pel_plane *line);
PEL_END_DECLS
#endif
