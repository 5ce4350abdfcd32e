/* Smooth triangles with a color per vertex. */
#ifndef PEL_SMOOTH_SMOOTH_GOURAUD_H
#define PEL_SMOOTH_SMOOTH_GOURAUD_H

#include "../raster/gouraud.h"
#include "../raster/plane.h"
#include "smooth_convex.h"

PEL_BEGIN_DECLS

/* The colors of a pel_gouraud, byte for byte where a pixel's centre lies inside
 * its triangle. Outside, where those wrap around, the planes go on and are cut
 * to 0..255: so pixels at an edge look like their neighbours. For shapes inside
 * of the triangle alone: full pixels of others wrap, as a pel_gouraud does. */
struct pel_smooth_gouraud {
    struct pel_paint paint;
    struct pel_gouraud inner;
    struct pel_plane channel[4]; /* in 2^-32 */
};

/* PEL_ERROR_NULL, PEL_ERROR_RANGE (a vertex out of range). */
enum pel_status pel_smooth_gouraud_init(struct pel_smooth_gouraud *paint,
                                        const struct pel_point v[3],
                                        const pel_color c[3]);

/* pel_smooth_triangle with that paint. With a pel_gouraud some pixels at its
 * edges may have wrong colors. */
void pel_smooth_triangle_gouraud(const struct pel_surface *surface,
                                 const struct pel_point v[3],
                                 const pel_color c[3]);
PEL_END_DECLS
#endif
