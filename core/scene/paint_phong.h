/* Light on every pixel. */
#ifndef PEL_SCENE_PAINT_PHONG_H
#define PEL_SCENE_PAINT_PHONG_H

#include "../paint/paint_colors.h"
#include "../raster/gouraud.h"
#include "light.h"
#include "plane.h"

PEL_BEGIN_DECLS

/* Colours a surface, lit at every pixel: normal and place are linear over the
 * screen and the normal is brought to length 1 again, without a division.
 * The surface's colour is that of another paint, or where `surface` is NULL
 * that of `colors`, to 1/256 step. Where opposite normals cancel out there is
 * ambient light alone. */
struct pel_phong {
    struct pel_color_paint base;
    const struct pel_mesh_lights *lights;
    const struct pel_color_paint *surface;
    struct pel_gouraud colors;
    struct pel_plane plane[6]; /* normal, place */
    uint8_t alpha;             /* of all, times that of the surface */
};

/* Sets the paint; its lights, surface, colours, planes and alpha are the
 * caller's to fill in. */
void pel_phong_init(struct pel_phong *paint, bool opaque);

/* A surface's colours times those of a triangle, as 0..1: light of its corners
 * on a texture. Alphas too. */
struct pel_modulated {
    struct pel_color_paint base;
    const struct pel_color_paint *surface;
    struct pel_gouraud tint;
};

void pel_tinted_init(struct pel_modulated *paint,
                     const struct pel_color_paint *surface, bool opaque);
PEL_END_DECLS
#endif
