/* Random and adversarial shapes, and windows from which they are looked at. */
#ifndef TESTS_SUPPORT_SHAPES_H
#define TESTS_SUPPORT_SHAPES_H

#include "cases.h"
#include "core/pel.h"

/* What the functions below make, failures print (cases.h): so do these with
 * shapes of other origin. Up to 12 points. */
void shape_keep(const struct pel_point *v, int32_t n);
void shape_keep_circle(struct pel_point center, int32_t radius);

/* The nearest coordinate that is legal. */
int32_t shape_legal(int64_t v);

/* Vertices anywhere in a box of 2 to 65,535 px, the box anywhere. */
void shape_random(struct random *r, struct pel_point *v, int32_t n);

/* What random vertices hardly ever test: centres and +-1 sub-pixel around them,
 * half pixels, axis-aligned and collinear vertices, slivers, tiny shapes, and
 * the ends of the range. */
void shape_adversarial(struct random *r, struct pel_point *v, int32_t n);

/* At most size x size px, legal as bounds of any surface whose origin may be
 * any multiple of 8; usually near a vertex or an edge, sometimes anywhere. */
struct pel_rect shape_window(struct random *r, const struct pel_point *v,
                             int32_t n, int32_t size);

/* Bounds of any surface, up to that size, near zero or anywhere. */
struct pel_rect shape_bounds(struct random *r, int32_t width, int32_t height);

/* The box of the pixels of 8 bits, inside the clip, that are not 0. */
struct pel_rect shape_box(const struct pel_surface *s);

/* The window, or a part of it (which may be empty). */
struct pel_rect shape_clip(struct random *r, const struct pel_rect *window);

/* All vertices in a box of `size` px that starts at (x, y) px, for canvases
 * that show the whole shape; on a lattice now and then. */
void shape_in_box(struct random *r, struct pel_point *v, int32_t n,
                  const struct pel_rect *box);

#endif
