/* Ordered dither: any paint, with the steps of a coarse format broken up. */
#ifndef PEL_PAINT_PAINT_DITHER_H
#define PEL_PAINT_PAINT_DITHER_H

#include "../base/status.h"
#include "../raster/paint.h"

PEL_BEGIN_DECLS

/* Colors of the source paint, moved to one of the two levels of the surface's
 * format next to them, by the 8 x 8 Bayer matrix at absolute x and y: so bands
 * and tiles agree, and a pixel does not depend on its neighbours. Over 8 x 8
 * pixels of one color the mean of what is shown is that color to 1/128 of the
 * step between two levels. Colors that are levels stay.
 *
 * Red, green and blue apart, or the grey of a color, with the bits that the
 * format's `depth` says; nothing in formats of 8 bits a channel, of inks,
 * and in the _fill ones. Acts on the source's color, before it is blended with
 * its alpha.
 */
struct pel_dither {
    struct pel_paint paint;
    const struct pel_paint *source;
};

/* The source must live as long as the paint and may be any paint but a dither.
 * The source sees a surface whose format, of id 255, moves each color before
 * the real format stores it: so code that is written for one format is not used
 * under a dither. PEL_ERROR_NULL, PEL_ERROR_RANGE (the source is a dither). */
enum pel_status pel_dither_init(struct pel_dither *paint,
                                const struct pel_paint *source);
PEL_END_DECLS
#endif
