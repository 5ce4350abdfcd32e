/* Patches: curved gradients where a CPU has vectors, many rows at a time.
 *
 * What such a gradient shows is the business of curve.h: a function of the
 * pixel alone, exact values joined by cubics along a row. Where all of a patch
 * of pixels is far from the centre, one polynomial of degree 3 in x and y comes
 * so near to that that it tells the cells of nearly all of them, and it is
 * stepped from pixel to pixel and from row to row by additions. The few pixels
 * whose cell it cannot tell, because its error reaches over the cell's end, are
 * coloured by the paint's own function: so a patch changes no byte. */
#ifndef PEL_PAINT_PATCH_H
#define PEL_PAINT_PATCH_H

#include "../format/vector.h"
#include "curve.h"
#include "paint_colors.h"

#define PEL_PATCHES (PEL_FAST_64BIT && PEL_VECTORS)

#if PEL_PATCHES

/* Sizes of patches: 32 by 16 pixels, half of that each way, and half again. */
enum { PEL_PATCH_SIZES = 3 };

/* How far away from the centre the middle of a patch must be, squared, in
 * sub-pixels: 179, 71.6 and 26.8 px, which is 10, 8 and 6 times as far as its
 * corner is from there. */
extern const int64_t pel_patch_far[PEL_PATCH_SIZES];

/* The position u pixels to the right of a pixel and v below it: at + x u + y v
 * + xx u^2 + xy u v + ..., in units of the curve and in two's complement. */
struct pel_taylor {
    uint64_t at, x, y, xx, xy, yy, xxx, xxy, xyy, yyy;

    /* On the patch around the pixel, -16 <= u < 16 and -8 <= v < 8 for the
     * largest size: it is off by less than this from what curve.h gives, */
    uint64_t error;

    /* and this is how far positions are from `at` at most; 0 where they repeat.
     */
    uint64_t reach;
};

/* That of the pixel whose centre is at (x, y) from the curve's, at least so far
 * away. */
typedef void pel_taylor_function(const struct pel_curve *curve, int32_t x,
                                 int32_t y, int size,
                                 struct pel_taylor *taylor);

pel_taylor_function pel_radial_taylor, pel_conic_taylor;

/* The colours of a run; `mixer` is a struct pel_ramp_mixer. */
typedef void pel_run_colors(const struct pel_color_paint *paint,
                            const void *mixer, const struct pel_run *run,
                            pel_color *colors);

/* A paint of patches. */
struct pel_patchwork {
    const struct pel_color_paint *paint;
    const struct pel_curve *curve;
    const struct pel_ramp *ramp;
    pel_taylor_function *taylor;
    pel_run_colors *colors;

    /* Pixels at (x, y) and (-x, y) from the centre have one position, but for
     * the errors of cubics. */
    bool mirrored;
};

struct pel_grid;

/* The lanes, the error, the width and `padded` of a patch around the pixel
 * centre `way` from the curve's. False where so many pixels would be in doubt
 * that it is no faster: one of 128 or more, of 64 or 32 of the smaller sizes;
 * four times as many where a padded ramp ends. */
bool pel_patch_grid(const struct pel_patchwork *work, struct pel_point way,
                    int size, struct pel_grid *grid);

/* What the paint's fill function is to do. */
void pel_patch_fill(const struct pel_patchwork *work,
                    const struct pel_spans *rows);

#endif
#endif
