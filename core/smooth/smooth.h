/* Smooth edges: each pixel is painted with the weight of its part that the
 * shape covers, the exact area, rounded to 0..255.
 *
 * Smooth shapes are named like the others, pel_smooth_triangle beside
 * pel_triangle, and take the same points, shapes and paints:
 *
 *  - a pixel of coverage 255 gets, byte for byte, what the paint stores there
 *    without smoothing; one of 0 stays untouched;
 *  - in between the color of the paint at the pixel's centre is put there with
 *    its alpha times coverage: round(alpha coverage / 255). Coverage is mixed
 *    like alpha, in sRGB as it is (base/color.h);
 *  - bands, tiles and clips change nothing: coverage is a function of the shape
 *    and the pixel.
 *
 * Shapes that share an edge let the background shine through there: half over
 * half leaves a quarter. So meshes are drawn without smoothing, and a smooth
 * polygon that belongs together is one polygon.
 *
 * The formats pel_rgb565_le_fill and pel_rgb565_be_fill cannot be blended: a
 * smooth shape on them is a broken contract, PEL_ASSERT, and draws nothing.
 *
 * The rest of this header is for those who write a smooth shape. A struct
 * pel_smooth is a surface before a surface: its format weighs what a paint puts
 * there and passes it on. Paints and formats know nothing of coverage. */
#ifndef PEL_SMOOTH_SMOOTH_H
#define PEL_SMOOTH_SMOOTH_H

#include "../raster/paint.h"

PEL_BEGIN_DECLS

/* A row of a shape: `left` pixels with a coverage each, then `middle` ones of
 * the same, then `right` ones. Each number may be 0. */
struct pel_smooth_row {
    int32_t y, x;                /* px: the first one */
    int32_t left, middle, right; /* px */
    const uint8_t *left_coverage, *right_coverage;
    uint32_t middle_coverage; /* 255 but for rows that are cut */
};

struct pel_smooth {
    struct pel_surface surface; /* first: the one that weighs */
    const struct pel_surface *target;
    const struct pel_paint *paint;
    struct pel_smooth_row row;
};

/* Begins a shape. False, and PEL_ASSERT, when the format cannot be blended.
 * The surface and the paint must live until the end. */
bool pel_smooth_begin(struct pel_smooth *smooth,
                      const struct pel_surface *surface,
                      const struct pel_paint *paint);

/* Paints a row, which lies inside the clip; its bytes are not used after the
 * call. No pixel may be in two rows. Full runs go to the paint on the real
 * surface, with all that is fast there. */
void pel_smooth_paint(struct pel_smooth *smooth,
                      const struct pel_smooth_row *row);

/* The same of the part of the row that is inside the clip. */
void pel_smooth_paint_clipped(struct pel_smooth *smooth,
                              const struct pel_smooth_row *row);

/* Paints what is left. */
void pel_smooth_end(struct pel_smooth *smooth);
PEL_END_DECLS
#endif
