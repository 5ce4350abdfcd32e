/* Hit testing: each function is true for exactly the pixels that the fill of
 * the same name covers, in a few multiplications: for a polygon, per edge that
 * crosses the row; for a sector or an arc after two directions, for a thick
 * line after a root. A pixel or a shape out of range is not hit. Outlines and
 * the clip do not count. */
#ifndef PEL_HIT_HIT_H
#define PEL_HIT_HIT_H

#include "../raster/polygon.h"
#include "../raster/thick_line.h"
#include "../round/arc.h"
#include "../round/ellipse.h"
#include "../round/ring.h"
#include "../round/rounded_rectangle.h"
#include "../round/sector.h"

PEL_BEGIN_DECLS

/* x, y: whole pixels, -32,768..32,767. */
bool pel_hit_triangle(const struct pel_point v[3], int32_t x, int32_t y);
bool pel_hit_rectangle(struct pel_point from, struct pel_point to, int32_t x,
                       int32_t y);
bool pel_hit_circle(struct pel_point center, int32_t radius, int32_t x,
                    int32_t y);
bool pel_hit_line(struct pel_point from, struct pel_point to, int32_t x,
                  int32_t y);
bool pel_hit_polygon(const struct pel_polygon_shape *polygon, int32_t x,
                     int32_t y);
bool pel_hit_ring(const struct pel_ring_shape *ring, int32_t x, int32_t y);
bool pel_hit_sector(const struct pel_sector_shape *sector, int32_t x,
                    int32_t y);
bool pel_hit_arc(const struct pel_arc_shape *arc, int32_t x, int32_t y);
bool pel_hit_ellipse(const struct pel_ellipse_shape *ellipse, int32_t x,
                     int32_t y);
bool pel_hit_rounded_rectangle(const struct pel_rounded_shape *rectangle,
                               int32_t x, int32_t y);
bool pel_hit_thick_line(const struct pel_thick_line_shape *line, int32_t x,
                        int32_t y);

/* Base of something that can be hit: the first member of a struct, as with
 * paints. It has no table of shapes, so that a program links only the hit tests
 * that it names:
 *
 *     struct button {
 *         struct pel_target target;
 *         struct pel_point center;
 *         int32_t radius;
 *     };
 *     static bool button_hit(const struct pel_target *t, int32_t x, int32_t y)
 *     {
 *         const struct button *b = (const struct button *)t;
 *         return pel_hit_circle(b->center, b->radius, x, y);
 *     } */
struct pel_target {
    bool (*hit)(const struct pel_target *target, int32_t x, int32_t y);
    struct pel_rect box; /* px: `hit` is called only for pixels inside; when the
                            box is empty, for every pixel */
};

/* The index of the last of n targets that covers the pixel: the topmost one,
 * when they are painted in the order of the list. -1 when none does. */
int32_t pel_hit_topmost(const struct pel_target *const *targets, int32_t n,
                        int32_t x, int32_t y);
PEL_END_DECLS
#endif
