/* A certificate for the painter's order: which pixels it may show wrong.
 *
 *     pel_scene_certify(&frame, proof, sizeof proof, 20000, &doubt);
 *     pel_scene_draw(&frame, &band); // at most doubt.pixels are wrong
 *
 * With memory for depths of `ROWS` rows, and bands no higher, none is:
 *
 *     part = pel_rect_intersect(&band.clip, &doubt.bounds);
 *     if (!pel_rect_empty(&part))
 *         pel_depth_init(&depth, &part, 32, depths, sizeof depths);
 *     pel_scene_draw_certified(&frame, &band, &doubt.bounds, &depth);
 */
#ifndef PEL_SCENE_CERTIFICATE_H
#define PEL_SCENE_CERTIFICATE_H

#include "pipeline.h"

PEL_BEGIN_DECLS

/* Where the painter's order is not proven. Elsewhere pel_scene_draw of an
 * opaque frame shows what pel_scene_draw_depth shows with 32 bits and the order
 * of the mesh: of each pixel's triangles the nearest, and of equally near ones
 * the first of the mesh. */
struct pel_doubt {
    uint32_t triangles;     /* that are in a pair without proof */
    uint32_t pixels;        /* at most so many are wrong */
    struct pel_rect bounds; /* px, around these; empty when there are none */
};

/* What the certificate knows of a triangle. */
struct pel_certificate_item {
    int16_t x0, y0, x1, y1; /* its pixels are inside, half-open */
    uint32_t low, high;     /* bounds of near / z (depth.h) */
    uint32_t rank;          /* in the order of the frame */
    bool thin, in_doubt;
};

/* Bytes of scratch memory for a frame of so many triangles: 32 each. */
#define PEL_CERTIFICATE_SCRATCH_SIZE(triangles) \
    (PEL_CAST(size_t, triangles) *              \
     (sizeof(struct pel_certificate_item) + sizeof(struct pel_depth_entry)))

/* Examines the order of a frame. Two triangles are in the right order when they
 * share no pixel, as their boxes or an edge of one shows; or the whole second
 * one is nearer than the first; or, in each row that they share, it is nearer
 * at both ends, by the very numbers that a depth buffer would hold. Triangles
 * that the near plane or the range of sub-pixels cuts are compared by their
 * distances alone.
 *
 * Takes at most about `work` steps: one to compare two boxes, 40 and one per
 * row to compare two triangles. What is left then is in doubt. UINT32_MAX
 * leaves nothing; 1,800 triangles of a duck took 340,000. Time grows with the
 * pairs that share rows. `scratch` is aligned to 4 bytes.
 * PEL_ERROR_NULL, PEL_ERROR_SCRATCH. */
enum pel_status pel_scene_certify(const struct pel_frame *frame, void *scratch,
                                  size_t scratch_size, uint32_t work,
                                  struct pel_doubt *doubt);

/* Draws an opaque frame as pel_scene_draw, and then what is inside `doubt` with
 * depths: the picture is that of pel_scene_draw_depth in the order of the mesh.
 * `depth` is cleared and holds the part of `doubt` on the surface; a surface
 * where there is none needs no depths: NULL. */
void pel_scene_draw_certified(struct pel_frame *frame,
                              const struct pel_surface *surface,
                              const struct pel_rect *doubt,
                              const struct pel_depth *depth);
PEL_END_DECLS
#endif
