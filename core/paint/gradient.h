/* Gradients: cells of equal color, drawn as shapes of one color.
 *
 * The way from 0 to 1 has n cells (color_ramp.h); they go on at both ends as
 * the ramp's spread says. Each kind says exactly which pixels a cell holds
 * (paint_linear.h, paint_radial.h, paint_conic.h). Nothing is rounded: bands,
 * tiles, clips, formats and CPUs change no byte. */
#ifndef PEL_PAINT_GRADIENT_H
#define PEL_PAINT_GRADIENT_H

#include "../raster/paint.h"
#include "color_ramp.h"

PEL_BEGIN_DECLS

/* The first member of every gradient. */
struct pel_gradient {
    struct pel_paint paint;

    /* The color of a cell, 0 <= cell < cells. */
    pel_color (*color)(const struct pel_gradient *gradient, int32_t cell);

    struct pel_ramp ramp;
    int32_t cells;  /* n, and 256 of two colors */
    int32_t period; /* cells until they begin anew; n where they do not */
};

/* Sets all but the paint. PEL_ERROR_NULL, PEL_ERROR_SIZE (the ramp's n). */
enum pel_status pel_gradient_init(struct pel_gradient *gradient,
                                  const struct pel_ramp *ramp);

PEL_END_DECLS

#endif
