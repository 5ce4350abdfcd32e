/* What drawing a frame takes at most, known once it is prepared. */
#ifndef PEL_SCENE_COST_H
#define PEL_SCENE_COST_H

#include "../raster/cost.h"
#include "pipeline.h"

PEL_BEGIN_DECLS

/* Instructions: of pel_scene_draw itself, of a triangle beside the clip, of
 * cutting one, and of one that is drawn. */
struct pel_scene_rates {
    uint32_t frame, beside, cut;
    struct pel_cost_rates drawn;
};

enum pel_scene_cost_kind {
    PEL_SCENE_COST_FLAT,
    PEL_SCENE_COST_GOURAUD,
    PEL_SCENE_COST_PHONG,
    PEL_SCENE_COSTS
};

/* Of pel_shade_lit_flat, pel_shade_lit_gouraud and pel_shade_phong with one
 * light and a shininess of 20, opaque, one color, without parts, texture and
 * depth buffer, on rgb565_le: gcc 12.2 -O2 for Cortex-M0+ and M4. There are
 * none of pel_shade_chosen. */
extern const struct pel_scene_rates pel_scene_cost_m0plus[PEL_SCENE_COSTS];
extern const struct pel_scene_rates pel_scene_cost_m4[PEL_SCENE_COSTS];

/* Adds the bound of pel_scene_draw onto that surface. A triangle that has to be
 * clipped counts as all that can be left of it: eight, no pixel twice. */
void pel_scene_cost(struct pel_cost *cost, const struct pel_frame *frame,
                    const struct pel_surface *surface,
                    const struct pel_scene_rates *rates);
PEL_END_DECLS
#endif
