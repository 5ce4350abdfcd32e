/* From a normal to a pixel: paints that make the colors of a triangle of values
 * at its pixels. Each value has a plane over the screen (raster/plane.h); one
 * walk along a row (shaded.c) steps them all, and a function makes the color of
 * a pixel of the values there. */
#ifndef PEL_SCENE_SHADED_H
#define PEL_SCENE_SHADED_H

#include "../paint/paint_colors.h"
#include "../raster/plane.h"
#include "light.h"

PEL_BEGIN_DECLS

struct pel_shaded;

/* The color of a pixel of the values there, without alpha, and of the surface
 * `under` it. */
typedef pel_color pel_pixel_function(const struct pel_shaded *paint,
                                     int32_t value[PEL_VALUES],
                                     pel_color under);

/* The surface, or colors that have planes, to 1/256 step, in the light; and the
 * surface times the colors. */
pel_pixel_function pel_lit_pixel, pel_modulated_pixel;

/* The planes hold over the triangle, or, where values are divided
 * (perspective.h), over the pixels at hand. */
struct pel_shaded {
    struct pel_color_paint base;
    const struct pel_color_paint *surface; /* NULL: of the color `under` */
    const struct pel_mesh_lights *lights;
    pel_pixel_function *pixel;
    uint8_t first, end; /* the values that have planes */
    uint8_t alpha;      /* multiplies that of the surface */
    pel_color under;
    struct pel_plane plane[PEL_VALUES];
};

pel_colors_function pel_shaded_colors;
PEL_END_DECLS
#endif
