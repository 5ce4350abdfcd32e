/* What pel_shade_chosen (core/scene/select.h) has chosen: counted, or shown. */
#ifndef SIM_RENDER_SCENE_METHODS_H
#define SIM_RENDER_SCENE_METHODS_H

#include "core/scene/select.h"

/* Pixels are those that are drawn, each as often as it is. Triangles count once
 * for each band and for each part that clipping leaves, and for both passes
 * through a depth buffer that translucent ones need. */
struct scene_methods {
    struct pel_color_paint paint; /* stands before the triangle's own */
    const struct pel_paint *inner;
    int at; /* the triangle's method */

    struct {
        uint32_t triangles;
        uint64_t pixels;
    } method[PEL_METHODS];
    uint32_t bound;          /* the largest, 1/256 step */
    int32_t lights_left_out; /* of the last frame */
};

/* pel_shade_chosen, counted in the `methods` of the struct scene that is drawn,
 * by one thread at a time; and every triangle in the color of its method. */
extern const struct pel_shading scene_shade_counted, scene_shade_methods;

void scene_methods_print(const struct scene_methods *methods);

#endif
