/* The exact area of a shape in a pixel, for smooth shapes: off by less than
 * 2^-40 px^2 where long double has 64 bits of fraction, 2^-24 where it is
 * double, up to a radius of 32,767 px. */
#ifndef TESTS_SUPPORT_REFERENCE_AREA_H
#define TESTS_SUPPORT_REFERENCE_AREA_H

#include "core/pel.h"
#include "tests/support/paint_math.h"

/* Convex, in px from some centre. */
struct area_polygon {
    int n;
    struct {
        real x, y;
    } v[12];
};

/* The pixel (x, y), from a centre in 1/256 px. */
struct area_polygon area_pixel(real center_x, real center_y, int32_t x,
                               int32_t y);

/* Keeps what has a x + b y <= c. */
void area_cut(struct area_polygon *p, real a, real b, real c);

real area_of_polygon(const struct area_polygon *p);

/* The area that the polygon shares with the disc around (0, 0), radius in px.
 */
real area_in_disc(const struct area_polygon *p, real radius);

#endif
