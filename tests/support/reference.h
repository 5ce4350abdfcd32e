/* What is right, written independently of core: every pixel centre is judged
 * by itself, in 128-bit arithmetic. Slow, and meant to be obviously so. */
#ifndef TESTS_SUPPORT_REFERENCE_H
#define TESTS_SUPPORT_REFERENCE_H

#include "core/pel.h"

__extension__ typedef __int128 wide;

/* n / d, d > 0. */
struct fraction {
    wide n, d;
};

/* Is pixel (x, y) in the triangle? Top-left rule; without area: never. */
bool reference_triangle_at(const struct pel_point v[3], int32_t x, int32_t y);

bool reference_disc_at(struct pel_point center, int32_t radius, int32_t x,
                       int32_t y);

/* How often the outline winds around the centre of (x, y), clockwise on screen;
 * an edge on the centre counts as left of it. */
int32_t reference_winding_at(const struct pel_polygon_shape *outline, int32_t x,
                             int32_t y);
bool reference_polygon_at(const struct pel_polygon_shape *outline, int32_t x,
                          int32_t y);

bool reference_line_at(struct pel_point from, struct pel_point to, int32_t x,
                       int32_t y);

/* First pixel of row y whose centre is on or right of the line through a and
 * b, a.y != b.y. */
int32_t reference_edge_at(const struct pel_point *a, const struct pel_point *b,
                          int32_t y);

/* The exact color of a channel (0 blue, 1 green, 2 red, 3 alpha) at the centre
 * of (x, y); the triangle has area. */
struct fraction reference_channel_at(const struct pel_point v[3],
                                     const pel_color c[3], int channel,
                                     int32_t x, int32_t y);

#endif
