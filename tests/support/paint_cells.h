/* Ramps whose colours tell the cell, and what a gradient must show. */
#ifndef TESTS_SUPPORT_PAINT_CELLS_H
#define TESTS_SUPPORT_PAINT_CELLS_H

#include "cases.h"
#include "core/paint/color_ramp.h"
#include "paint_math.h"

enum { CELLS_MAX = 32767 };

/* A ramp of n cells of which cell i has the colour 0xFF000000 + i; two cells
 * are black and white, which are mixed to 256 greys. All ramps share memory. */
struct pel_ramp cells_ramp(int32_t n, enum pel_spread spread);

/* n and spread at random, small and large. */
struct pel_ramp cells_random(struct random *r);

/* How far from t the ramp first shows `color`, in units of the way; 1 when it
 * is not within `reach`. */
real cells_distance(const struct pel_ramp *ramp, pel_color color, real t,
                    real reach);

/* The exact channel (0 blue .. 3 alpha), 0..255, of linear stops at t. */
real stops_channel(const struct pel_stop *stops, int32_t count,
                   enum pel_spread spread, real t, int channel);

#endif
