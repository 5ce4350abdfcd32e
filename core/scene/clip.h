/* Triangles that reach behind the near plane, or out of what sub-pixels can
 * say, cut to a polygon that does not. */
#ifndef PEL_SCENE_CLIP_H
#define PEL_SCENE_CLIP_H

#include "projector.h"

/* A corner of the polygon: its coarse place, and how much of each vertex of the
 * triangle is in it, 2^-30; one of them is PEL_COSINE_ONE at a vertex. */
struct pel_clip_corner {
    int32_t place[3];
    int32_t weight[3];
};

/* Five planes add a corner each. */
enum { PEL_CLIP_CORNERS = 8 };

struct pel_clip {
    struct pel_clip_corner corner[PEL_CLIP_CORNERS]; /* the polygon */
    struct pel_clip_corner spare[PEL_CLIP_CORNERS];  /* before: the places */
};

/* Cuts the triangle with the places of clip->spare[0] to [2] by the near plane
 * and by the four planes of the guard band, the legal range of sub-pixels less
 * a pixel, and returns the number of corners of what is left, in the triangle's
 * order: up to 8; fewer than 3 are nothing. Two triangles that share an edge
 * are cut at the same places of it: a cut depends on the ends of the edge
 * alone, not on their order, and is right to a coarse step. */
int32_t pel_clip_triangle(const struct pel_projector *projector,
                          struct pel_clip *clip);

#endif
