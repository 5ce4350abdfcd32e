/* Who is in front: the order in which triangles are drawn, and depths. */
#ifndef SIM_RENDER_SCENE_ORDER_H
#define SIM_RENDER_SCENE_ORDER_H

#include <stdio.h>

#include "sim/render/scene.h"

/* Sets depth_bits, and the sort where it is needed for the order; before a
 * frame of the scene is prepared. SCENE_AUTO sorts where a proof of the
 * painter's order is likely to take less time than a depth buffer; it takes one
 * otherwise. */
void scene_set_order(struct scene *scene, const struct scene_settings *s);

/* Tries the proof, in as much time as the depths would take at most. Where it
 * fails for a part of the picture, depths are kept for that part, or for all
 * of it. */
void scene_prove_order(struct scene *scene);

/* Draws a part of the picture as was decided; false, with a message, when
 * there is no memory. The frame is a copy of the scene's, with its own work. */
bool scene_draw_ordered(const struct scene *scene, struct pel_frame *frame,
                        const struct pel_surface *surface);

/* Prints how triangles are ordered, and for SCENE_PAINTER how many pixels may
 * be wrong. */
void scene_print_order(FILE *out, const struct scene *scene);

#endif
