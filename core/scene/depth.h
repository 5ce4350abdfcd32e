/* Depth buffers: of the triangles that meet in a pixel the nearest is seen. */
#ifndef PEL_SCENE_DEPTH_H
#define PEL_SCENE_DEPTH_H

#include <stddef.h>

#include "../base/status.h"
#include "../paint/paint_colors.h"
#include "../raster/plane.h"
#include "camera.h"

PEL_BEGIN_DECLS

/* A number per pixel, in the caller's memory: near / z of what is seen there,
 * as a fraction of 16 or 32 bits; 0 is nothing. Such numbers are linear on
 * screen. At distance z two surfaces are told apart when they are more than
 * z^2 / (near 2^16) apart, or 2^-13 of that with 32 bits. */
struct pel_depth {
    void *values; /* of pixel (bounds.x0, bounds.y0) */
    struct pel_rect bounds;
    uint8_t bits;
};

/* Bytes for so many pixels, bits 16 or 32, for constant expressions. */
#define PEL_DEPTH_SIZE(width, height, bits) \
    (PEL_CAST(size_t, width) * PEL_CAST(size_t, height) * ((bits) / 8))

/* Bytes for `bounds`; 0 when no surface can have them (pel_bounds_legal), bits
 * is not 16 or 32, or the bytes exceed a size_t. */
size_t pel_depth_size(const struct pel_rect *bounds, int bits);

/* Makes a cleared buffer. `bounds`, in pixels, should be those of the surface
 * or band: nothing is drawn outside. PEL_ERROR_NULL, PEL_ERROR_SIZE,
 * PEL_ERROR_SCRATCH (memory too small, or not aligned to bits / 8 bytes). */
enum pel_status pel_depth_init(struct pel_depth *depth,
                               const struct pel_rect *bounds, int bits,
                               void *memory, size_t size);

void pel_depth_clear(const struct pel_depth *depth);

/* The largest depth of a corner; the smallest is 0. */
#define PEL_DEPTH_NEAR ((INT32_C(1) << 30) - (INT32_C(1) << 14))

/* near / z of a coarse z in front of the near plane, times PEL_DEPTH_NEAR. */
int32_t pel_nearness(const struct pel_projector *projector, int32_t z);

/* A paint between a shape and its own paint: lets through the pixels where
 * `plane` is nearer than the buffer. Of equal ones the first drawn stays. */
struct pel_depth_paint {
    struct pel_color_paint base;
    const struct pel_paint *inner;
    const struct pel_depth *depth;
    struct pel_plane plane; /* values 0..PEL_DEPTH_NEAR */
    bool keeps;             /* stores the depth of what it lets through */
};

/* `fast` of such a paint (raster/paint.h), for flat and Gouraud ones inside it;
 * core/fast/fast_depth.c says which. */
bool pel_depth_fast(const struct pel_paint *paint,
                    const struct pel_surface *surface,
                    const struct pel_fast_triangle *triangle);

void pel_depth_paint_init(struct pel_depth_paint *paint,
                          const struct pel_paint *inner,
                          const struct pel_depth *depth,
                          const struct pel_plane *plane, bool keeps);
PEL_END_DECLS
#endif
