/* Colors, normals and positions in perspective: linear in the world. */
#ifndef PEL_SCENE_PERSPECTIVE_H
#define PEL_SCENE_PERSPECTIVE_H

#include "divided.h"
#include "shaded.h"

PEL_BEGIN_DECLS

struct pel_frame;
struct pel_shading;

/* A triangle whose values from `first` on are divided: a paint that sets the
 * values of `shaded` to those at hand, and `out` to the surface's colors, and
 * calls its function. */
struct pel_divided_triangle {
    struct pel_color_paint base;
    struct pel_shaded *shaded;
    const struct pel_color_paint *surface; /* or NULL */
    struct pel_divided by;
    uint8_t first;
    struct pel_divided_value value[PEL_VALUES];
};

/* Sets a value of the triangle at hand from those at its vertices. */
typedef void pel_value_function(struct pel_frame *frame, int k,
                                const int32_t vertex[3]);

/* How shadings divide, where it makes a difference: where the distances of a
 * triangle's corners are so near to each other that colors which are linear on
 * screen are within 1/4 step, its functions return NULL or false. */
struct pel_division {
    /* The paint of colors at the vertices. */
    const struct pel_paint *(*gouraud)(struct pel_frame *frame,
                                       const struct pel_color_paint *surface,
                                       const pel_color color[3]);

    /* Sets the colors, if there is no surface, of work->paint.shaded, one that
     * is lit at pixels; work->divided is its paint. */
    bool (*light)(struct pel_frame *frame, const pel_color color[3]);
    pel_value_function *value; /* for its other values */
};

/* Colors alone are divided every 8 pixels, or at every one where they would be
 * off by more than 1/4 step between; with normals and positions all are divided
 * at every one, as light near a lamp shows the least change of a position. */
extern const struct pel_division pel_division;

/* Shadings of shading.h with colors, normals and positions as
 * they are in the world: pel_shade_gouraud, ... */
extern const struct pel_shading pel_perspective_gouraud;
extern const struct pel_shading pel_perspective_lit_gouraud;
extern const struct pel_shading pel_perspective_phong;
PEL_END_DECLS
#endif
