/* Triangles with a color per vertex, interpolated linearly. */
#ifndef PEL_RASTER_GOURAUD_H
#define PEL_RASTER_GOURAUD_H

#include "triangle.h"

PEL_BEGIN_DECLS

/* A paint whose channels are planes over the screen, stepped modulo 2^32 in
 * 8.24 from pixel (0, 0): pixel (x, y) has (at + x * dx + y * dy) >> 24. Since
 * only the value at covered pixels must fit, a gradient may wrap: slivers need
 * no special case. Valid on pixels inside the triangle that it was made from;
 * elsewhere the colors wrap around. Channels: blue, green, red, alpha. */
struct pel_gouraud {
    struct pel_paint paint;
    uint32_t at[4], dx[4], dy[4];
};

static inline bool pel_gouraud_opaque(const struct pel_gouraud *g)
{
    return g->at[3] >> 24 == 255 && (g->dx[3] | g->dy[3]) == 0;
}

/* Makes the paint of a triangle with the colors c[i] at v[i]. The value at a
 * pixel's centre is off by at most (|x - x0| + |y - y0| + 1) 2^-17 steps of
 * 255, (x0, y0) the pixel of the topmost vertex, and by at most 1/16 step
 * before it is rounded: at most 1 from the exactly rounded color. It depends
 * on the vertices alone, not on their order, the clip or the band. A triangle
 * without area covers nothing and may get any color. PEL_ERROR_NULL,
 * PEL_ERROR_RANGE (a vertex out of range). */
enum pel_status pel_gouraud_init(struct pel_gouraud *paint,
                                 const struct pel_point v[3],
                                 const pel_color c[3]);

void pel_gouraud_fill(const struct pel_paint *paint,
                      const struct pel_spans *spans);

/* pel_triangle with that paint. */
void pel_triangle_gouraud(const struct pel_surface *surface,
                          const struct pel_point v[3], const pel_color c[3]);
PEL_END_DECLS
#endif
