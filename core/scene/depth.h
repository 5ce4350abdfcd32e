/* Depth buffers: which of the surfaces that meet in a pixel is nearest. */
#ifndef PEL_SCENE_DEPTH_H
#define PEL_SCENE_DEPTH_H

#include <stddef.h>

#include "../base/status.h"
#include "../paint/paint_colors.h"
#include "plane.h"

PEL_BEGIN_DECLS

/* A number per pixel, of the caller's memory: near / z of what is seen there,
 * as a fraction of 16 or 32 bits; 0 is nothing. Such numbers are linear on
 * screen. Two places are told apart at distance z when their gap is more than
 * z^2 / (near 2^16), or 2^-13 of that with 32 bits. */
struct pel_depth {
    void *values; /* of pixel (bounds.x0, bounds.y0) */
    struct pel_rect bounds;
    uint8_t bits;
};

/* Bytes for so many pixels, bits 16 or 32, for constant expressions. */
#define PEL_DEPTH_SIZE(width, height, bits) \
    (PEL_CAST(size_t, width) * PEL_CAST(size_t, height) * ((bits) / 8))

/* Bytes for `bounds`; 0 when they are none of a surface (pel_bounds_legal),
 * bits not 16 or 32, or when the bytes are more than a size_t can say. */
size_t pel_depth_size(const struct pel_rect *bounds, int bits);

/* `bounds` as of a surface, of which it should be those: nothing is drawn
 * outside. The buffer may be that of a band. Cleared. PEL_ERROR_NULL,
 * PEL_ERROR_SIZE, PEL_ERROR_SCRATCH (too small, or not aligned to a number). */
enum pel_status pel_depth_init(struct pel_depth *depth,
                               const struct pel_rect *bounds, int bits,
                               void *memory, size_t size);

void pel_depth_clear(const struct pel_depth *depth);

/* A value of corners: 0 to this. */
#define PEL_DEPTH_NEAR ((INT32_C(1) << 30) - (INT32_C(1) << 14))

/* A paint between a shape and its paint: lets through the pixels where `plane`
 * is nearer than what the buffer holds. Of equal ones the first drawn stays. */
struct pel_depth_paint {
    struct pel_color_paint base;
    const struct pel_paint *inner;
    const struct pel_depth *depth;
    struct pel_plane plane; /* values 0..PEL_DEPTH_NEAR */
    bool keeps;             /* what is let through, in the buffer */
};

/* keeps: or only tests, for what can be seen through. */
void pel_depth_paint_init(struct pel_depth_paint *paint,
                          const struct pel_paint *inner,
                          const struct pel_depth *depth,
                          const struct pel_plane *plane, bool keeps);

/* Of a paint whose colours have any alpha, lets the opaque ones through, and
 * keeps them. */
void pel_depth_texels_init(struct pel_depth_paint *paint,
                           const struct pel_color_paint *inner,
                           const struct pel_depth *depth,
                           const struct pel_plane *plane);

PEL_END_DECLS
#endif
