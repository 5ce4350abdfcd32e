/* Clipping of one triangle in camera space. */
#ifndef SIM_MESH_CLIP_H
#define SIM_MESH_CLIP_H

#include "camera_view.h"

enum { CLIP_PLANES = 5, CLIP_CORNERS_MAX = 3 + CLIP_PLANES };

/* Where a plane is 0: a x + b y + c z + d; inside is >= 0. */
struct clip_planes {
    double plane[CLIP_PLANES][4];
};

struct clip_corner {
    double point[3]; /* camera space */
    double color[3]; /* red, green, blue */
    double uv[2];
};

/* The near plane, and the four planes through the eye and +-32,000 px on the
 * screen. */
void clip_planes_init(struct clip_planes *planes,
                      const struct camera_view *view);

/* Bit i is set where the point is outside of plane i. */
unsigned clip_outside(const struct clip_planes *planes, const double point[3]);

/* Cuts the polygon of n corners, with room for CLIP_CORNERS_MAX, in place. The
 * new corners of a side are a function of its two ends, not of their order or
 * of the polygon, so that neighbours keep a common edge. Returns the number of
 * corners, 0 when nothing is left. */
int clip_polygon(const struct clip_planes *planes, struct clip_corner *corner,
                 int n);

#endif
