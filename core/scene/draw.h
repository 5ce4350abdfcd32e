/* The loop over a frame's triangles, which draw calls share. */
#ifndef PEL_SCENE_DRAW_H
#define PEL_SCENE_DRAW_H

#include "pipeline.h"

/* Puts itself between a triangle and its paint. */
typedef const struct pel_paint *pel_frame_filter(struct pel_frame *frame,
                                                 const struct pel_paint *paint,
                                                 const struct pel_depth *depth);

/* filter may be NULL. */
void pel_frame_draw(struct pel_frame *frame, const struct pel_surface *surface,
                    pel_frame_filter *filter, const struct pel_depth *depth);

#endif
