/* Triangles that reach behind the near plane, or out of what sub-pixels can
 * say, cut to a polygon that does not. */
#ifndef PEL_SCENE_CLIP_H
#define PEL_SCENE_CLIP_H

#include "camera.h"

PEL_BEGIN_DECLS

/* A corner of the polygon: its coarse place, and how much of each vertex of the
 * triangle is in it, 2^-30; one of them is PEL_COSINE_ONE at a vertex. */
struct pel_clip_corner {
    int32_t place[3];
    int32_t weight[3];
    int64_t inside; /* of the plane at work: how far, or below 0 */
};

/* Five planes add a corner each, and make two; a polygon that rounding has bent
 * at its edge, one more. */
enum { PEL_CLIP_CORNERS = 10, PEL_CLIP_MADE = 3 + 12 };

typedef struct pel_clip_corner *pel_clip_polygon[PEL_CLIP_CORNERS];

struct pel_clip {
    struct pel_clip_corner corner[PEL_CLIP_MADE]; /* 0 to 2: the triangle's */
    pel_clip_polygon polygon[2];
};

/* Once: corners 0 to 2 are vertices, which no cut changes. */
void pel_clip_start(struct pel_clip *clip);

/* Cuts the triangle with the places of clip->corner[0] to [2] by the near plane
 * and by the four planes of the guard band, the legal range of sub-pixels less
 * a pixel, and leaves the corners in clip->polygon[0], in the triangle's order.
 * Their number, up to PEL_CLIP_CORNERS; fewer than 3 are nothing. Two triangles
 * that share an edge are cut at the same places of it: a cut depends on the
 * ends of the edge alone, not on their order, and is right to a coarse step. */
int32_t pel_clip_triangle(const struct pel_projector *projector,
                          struct pel_clip *clip);
PEL_END_DECLS
#endif
