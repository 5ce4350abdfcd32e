/* Shadings: where on a triangle colours are computed. */
#ifndef PEL_SCENE_SHADING_H
#define PEL_SCENE_SHADING_H

#include "frame.h"

PEL_BEGIN_DECLS

struct pel_shading {
    /* Once a frame, before the vertices. May be NULL. */
    enum pel_status (*start)(struct pel_frame *frame);

    /* The colour that a vertex keeps, `surface` its own. NULL: that. */
    pel_color (*vertex)(const struct pel_frame *frame, uint32_t vertex,
                        pel_color surface);

    /* The paint of frame->work->triangle. `surface` is a texture that is mapped
     * to every pixel, or NULL; where it is not opaque, the paint is a struct
     * pel_color_paint too. */
    const struct pel_paint *(*paint)(struct pel_frame *frame,
                                     const struct pel_color_paint *surface);
};

/* Without light: the colours of the vertices, or of a texture, as they are.
 * Flat: the mean of the three, rounded. Gouraud: linear on screen. */
extern const struct pel_shading pel_shade_flat;
extern const struct pel_shading pel_shade_gouraud;

/* The same with light at the vertices (light.h). A texture that is mapped to
 * every pixel is multiplied with what light makes of white, highlights too. */
extern const struct pel_shading pel_shade_lit_flat;
extern const struct pel_shading pel_shade_lit_gouraud;

/* Light at every pixel: normal, place and surface colour are linear on screen,
 * the normal brought to length 1. */
extern const struct pel_shading pel_shade_phong;

/* Parts of them. */
enum pel_status pel_shade_start_light(struct pel_frame *frame);
pel_color pel_shade_light_vertex(const struct pel_frame *frame, uint32_t vertex,
                                 pel_color surface);
const struct pel_paint *pel_shade_flat_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface);
const struct pel_paint *pel_shade_gouraud_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface);
PEL_END_DECLS
#endif
