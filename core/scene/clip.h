/* Clipping: triangles behind the near plane or out of the range of sub-pixels
 * are cut to a polygon inside. */
#ifndef PEL_SCENE_CLIP_H
#define PEL_SCENE_CLIP_H

#include "camera.h"

PEL_BEGIN_DECLS

/* A corner of the polygon: where it is, fine; the weights of the triangle's
 * vertices, 2^-30, where a vertex has a weight of PEL_COSINE_ONE; and its z,
 * coarse, below 0 outside of the plane that cuts. */
struct pel_clip_corner {
    int64_t at[3];
    int32_t weight[3];
    int32_t z;
};

/* Five planes add a corner each and make two new ones; rounding may bend the
 * polygon at an edge, which adds one more. */
enum { PEL_CLIP_CORNERS = 10, PEL_CLIP_MADE = 3 + 12 };

typedef struct pel_clip_corner *pel_clip_polygon[PEL_CLIP_CORNERS];

struct pel_clip {
    struct pel_clip_corner corner[PEL_CLIP_MADE]; /* 0 to 2: the triangle's */
    pel_clip_polygon polygon[2];
};

/* Sets the weights of corners 0 to 2, the vertices; no cut changes them. */
void pel_clip_start(struct pel_clip *clip);

/* Cuts the triangle with the places of clip->corner[0] to [2] by the near
 * plane and the four planes of the guard band, the legal range of sub-pixels
 * less a pixel. The corners of the rest are in clip->polygon[0], in the
 * triangle's order; returns their number, up to PEL_CLIP_CORNERS, fewer than 3
 * when nothing is left. Triangles that share an edge are cut at the same points
 * of it: a cut depends on the ends of the edge alone, not on their order. It is
 * on the edge to a few fine steps, and inside of the plane by less than 2^-29
 * of the edge and a coarse step. */
int32_t pel_clip_triangle(const struct pel_projector *projector,
                          struct pel_clip *clip);
PEL_END_DECLS
#endif
