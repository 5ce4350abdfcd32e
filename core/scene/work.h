/* What shadings and mappings are made of: a triangle at hand, and the memory
 * for it. */
#ifndef PEL_SCENE_WORK_H
#define PEL_SCENE_WORK_H

#include "../raster/gouraud.h"
#include "clip.h"
#include "depth.h"
#include "mapping.h"
#include "divided.h"
#include "shaded.h"

PEL_BEGIN_DECLS

struct pel_frame_vertex {
    struct pel_projected at;
    pel_color color; /* of triangles that may be seen; 0: see pel_frame_color */
};

/* A triangle to draw: one of the mesh, or a part of it that clipping left. */
struct pel_frame_triangle {
    bool is_whole; /* its corners are the vertices */
    bool is_set_up;
    uint8_t method; /* where one is chosen (select.h) */
    uint32_t bound; /* then of its error, 1/256 step */
    uint32_t vertex[3];
    pel_color color[3]; /* of the vertices, when it is drawn */
    struct pel_point at[3];
    const struct pel_clip_corner *corner[3];
};

/* Scratch memory for one triangle at a time. */
struct pel_frame_work {
    struct pel_frame_triangle triangle;
    struct pel_surface surface;
    struct pel_plane_setup setup; /* of the triangle: see pel_frame_setup */
    union {
        struct pel_flat flat;
        struct pel_gouraud gouraud;
        struct pel_shaded shaded;
    } paint;
    struct pel_texture texture; /* of the part; mappings set its map */
    struct pel_divided_texture perspective;
    struct pel_depth_paint depth;
    struct pel_clip clip;
};

/* Sets the part at hand: number i, 0 for a mesh without parts. Errors of
 * pel_scene_prepare about textures. */
enum pel_status pel_frame_set_part(struct pel_frame *frame, uint32_t i);

/* Sets it to that of a triangle of the mesh. */
void pel_frame_find_part(struct pel_frame *frame, uint32_t triangle);

/* The values at the corners from those at the vertices, |value| <= 2^30. */
void pel_corners_mix(const struct pel_frame_triangle *triangle,
                     const int32_t vertex[3], int32_t corner[3]);

/* The plane set-up of frame->work->triangle, computed by the first call. */
const struct pel_plane_setup *pel_frame_setup(struct pel_frame *frame);

/* The plane of a value over that triangle, from its three vertices. */
void pel_frame_plane(struct pel_frame *frame, const int32_t value[3],
                     struct pel_plane *plane);

/* The normal and the position of a vertex. */
void pel_frame_values(const struct pel_frame *frame, uint32_t vertex,
                      int32_t value[PEL_LIGHT_VALUES]);

/* Sets the paint to colors that are linear over that triangle, from those of
 * its vertices, right to 2^-6 step. */
void pel_frame_gouraud(struct pel_frame *frame, const pel_color color[3],
                       struct pel_gouraud *paint);

/* The color of a vertex, lit by shadings that light vertices; computed by the
 * first call. */
pel_color pel_frame_color(const struct pel_frame *frame, uint32_t vertex);

/* Where a corner that clipping left of that triangle is on screen. A vertex
 * that is on screen keeps its sub-pixel, so that triangles around it meet
 * there. */
struct pel_point pel_frame_corner_at(const struct pel_frame *frame,
                                     const struct pel_clip_corner *corner);

/* Begins work->paint.shaded, all but its planes, for a function that takes the
 * values from `first` on. */
struct pel_shaded *pel_shaded_start(struct pel_frame *frame,
                                    const struct pel_color_paint *surface,
                                    const pel_color color[3],
                                    pel_pixel_function *pixel, int first);

/* Sets the plane of value k of it, from those at the triangle's vertices: this
 * one to values that are linear on screen. */
typedef void pel_value_function(struct pel_frame *frame, int k,
                                const int32_t vertex[3]);
pel_value_function pel_value_plane;

/* Call `set` for each of the colors, in steps, and for all values of light. */
void pel_color_planes(struct pel_frame *frame, const pel_color color[3],
                      pel_value_function *set);
void pel_phong_values(struct pel_frame *frame, const pel_color color[3],
                      pel_value_function *set);

/* What mappings are made of. Sets the corners of frame->work->triangle; the
 * affine surface of it; `modulate`. */
void pel_frame_texels(const struct pel_frame *frame,
                      struct pel_texture_corner corner[3]);
const struct pel_color_paint *pel_frame_affine(struct pel_frame *frame);
pel_shade_function pel_frame_modulate;

PEL_END_DECLS
#endif
