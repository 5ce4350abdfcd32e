/* Two triangles of a frame: is one proven to be nearer wherever they meet? */
#ifndef PEL_SCENE_CERTIFICATE_PAIR_H
#define PEL_SCENE_CERTIFICATE_PAIR_H

#include "certificate.h"
#include "work.h"

/* A triangle of the mesh as it is on screen; `at` is right unless it is cut. */
struct pel_certificate_corners {
    struct pel_point at[3];
    int32_t z[3];  /* coarse */
    bool cut;      /* by the near plane or the range of sub-pixels */
    bool in_front; /* of the near plane, all of it */
};

void pel_certificate_corners(const struct pel_frame *frame, uint32_t triangle,
                             struct pel_certificate_corners *corners);

/* Adds pixels inside `box`, which is not empty, to a doubt. */
void pel_doubt_add(struct pel_doubt *doubt, const struct pel_rect *box,
                   uint32_t pixels);

/* Pixels of a rectangle that is not empty, inside the range of surfaces. */
static inline uint32_t pel_doubt_area(const struct pel_rect *r)
{
    return PEL_CAST(uint32_t, r->x1 - r->x0) *
           PEL_CAST(uint32_t, r->y1 - r->y0);
}

/* The doubt about two triangles of the mesh, drawn in this order, that may
 * share pixels of `common` alone; `triangles` stays 0. Neither is `thin` where
 * depths are right to 2^-6 (raster/plane.h). */
struct pel_doubt pel_certificate_pair(const struct pel_frame *frame,
                                      const uint32_t triangle[2], bool thin,
                                      const struct pel_rect *common);
#endif
