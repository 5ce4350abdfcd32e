/* A triangle fan: a color per vertex on polygons, circles and other shapes. */
#ifndef PEL_PAINT_PAINT_FAN_H
#define PEL_PAINT_PAINT_FAN_H

#include "../raster/plane.h"
#include "paint_colors.h"

PEL_BEGIN_DECLS

/* A hub and a perimeter of n points around it, each with a color. Between the
 * rays from the hub through two neighbours of the perimeter the colors are
 * those of the triangle of the three points, linear in x and y, beyond the
 * perimeter too, each channel clamped to 0..255 (any color where it would be
 * more than 2^31 steps beyond: slivers, seen from far off). So
 *  - a polygon whose corners are the perimeter is covered by n triangles with a
 *    color at every vertex, without a seam;
 *  - a disc with the perimeter on its circle (pel_fan_perimeter) likewise;
 *  - three points around a hub that has their mean place and color make the
 *    triangle with a color per vertex itself. */
struct pel_fan_points {
    struct pel_point hub;
    pel_color hub_color;
    const struct pel_point *perimeter; /* once around the hub */
    const pel_color *colors;           /* one a point */
    int32_t n;                         /* 3..32,767 */
};

/* Sets the hub to the mean of the points and colors, rounded: the middle of
 * regular polygons, and inside of all that are convex. perimeter, colors and n
 * are set; n < 1 is a broken contract: PEL_ASSERT, and the hub stays. */
void pel_fan_set_hub(struct pel_fan_points *points);

/* n points evenly around a circle, the first at the angle start (1/65,536
 * turns), clockwise; n > 0. Their angles are whole 65,536ths, rounded down: a
 * point is within radius / 8,000 and a sub-pixel of its place. A circle out of
 * range is a broken contract: PEL_ASSERT, and the points stay as they are. */
void pel_fan_perimeter(struct pel_point *v, int32_t n, struct pel_point center,
                       int32_t radius, uint16_t start);

/* The triangle between a point of the perimeter and the next; its first ray is
 * part of it. Channels, from blue to alpha, are in 2^-32 steps. */
struct pel_fan_triangle {
    struct pel_point from, past; /* the first ray, from the hub, and the last
                                    one turned back; 0 without area */
    int32_t closed;              /* 1: the last ray too, as none follows */
    struct pel_plane channel[4];
};

struct pel_fan {
    struct pel_color_paint base;
    struct pel_point hub;
    pel_color hub_color;                      /* outside of all triangles */
    const struct pel_fan_triangle *triangles; /* n */
    int32_t n;
};

/* Channels are off by less than 2^-14 steps before they are rounded. `memory`,
 * for n triangles, belongs to the caller and must last as long as the paint;
 * the points need not. The hub may lie on an edge of the polygon or be one of
 * its corners: pixels between no two rays then have its color. PEL_ERROR_NULL,
 * PEL_ERROR_SIZE (n), PEL_ERROR_RANGE (a point out of range, or the perimeter
 * turns back as seen from the hub, or goes around it more than once). */
enum pel_status pel_fan_init(struct pel_fan *paint,
                             const struct pel_fan_points *points,
                             struct pel_fan_triangle *memory);
PEL_END_DECLS
#endif
