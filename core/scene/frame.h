/* What a scene becomes on its way to pixels: for shadings and mappings. */
#ifndef PEL_SCENE_FRAME_H
#define PEL_SCENE_FRAME_H

#include "clip.h"
#include "depth.h"
#include "paint_perspective.h"
#include "paint_phong.h"
#include "scene.h"

PEL_BEGIN_DECLS

struct pel_frame;

struct pel_frame_vertex {
    struct pel_projected at;
    pel_color color; /* lit, where vertices are */
};

/* What is drawn: a triangle of the mesh, or a part of what is left of it. */
struct pel_frame_triangle {
    uint32_t vertex[3];
    struct pel_point at[3];
    const struct pel_clip_corner *corner[3];
    bool is_set_up;
    struct pel_plane_setup setup; /* ask pel_frame_setup for it */
};

/* Puts itself between a triangle and its paint. */
typedef const struct pel_paint *pel_frame_filter(struct pel_frame *frame,
                                                 const struct pel_paint *paint);

/* Memory that is worked on: one triangle at a time. */
struct pel_frame_work {
    struct pel_surface surface;
    struct pel_frame_triangle triangle;
    union {
        struct pel_flat flat;
        struct pel_gouraud gouraud;
        struct pel_modulated tinted;
        struct pel_phong phong;
    } paint;
    struct pel_perspective perspective;
    struct pel_depth_paint depth;
    struct pel_clip clip;
};

struct pel_frame {
    const struct pel_scene *scene;
    struct pel_frame_work *work;
    struct pel_frame_vertex *vertex;
    struct pel_depth_entry *order;
    pel_frame_filter *filter; /* or NULL */
    uint32_t triangles;       /* in `order`: those that may be seen */
    uint8_t alpha;
    bool opaque;
    struct pel_mesh_fault fault; /* when an index is wrong */
    struct pel_mesh_lights lights;
    struct pel_texture texture; /* the sampler; its map is worked on */
    struct pel_projector projector;
};

/* The values at the corners from those at the vertices, |value| <= 2^30. */
void pel_corners_mix(const struct pel_frame_triangle *triangle,
                     const int32_t vertex[3], int32_t corner[3]);

/* What planes of frame->work->triangle share: made when it is first asked for.
 */
const struct pel_plane_setup *pel_frame_setup(struct pel_frame *frame);

/* The plane of a value over that triangle, from its three vertices. */
void pel_frame_plane(struct pel_frame *frame, const int32_t value[3],
                     struct pel_plane *plane);

/* The planes of three, value[i][k] at vertex i. */
void pel_frame_planes(struct pel_frame *frame, int32_t value[3][3],
                      struct pel_plane plane[3]);

/* Colours that are linear over it, from those of its vertices: the planes of
 * `paint`, which are right to 2^-6 step. */
void pel_frame_gouraud(struct pel_frame *frame, const pel_color color[3],
                       struct pel_gouraud *paint);

/* The colours of its vertices. */
void pel_frame_colors(const struct pel_frame *frame, pel_color color[3]);

/* Takes a triangle of the mesh: its vertices to frame->work->triangle, with
 * `at` where all of it is on screen, its corners to clip->corner and to polygon
 * 0, with z as their only place; the sum of that to `depth`. */
enum pel_frame_taken { PEL_TAKEN_BEHIND, PEL_TAKEN_WHOLE, PEL_TAKEN_CUT };
enum pel_frame_taken pel_frame_take(const struct pel_frame *frame,
                                    uint32_t triangle, int32_t *depth);

/* Corner i of that triangle, from what cutting left of it: a vertex that is on
 * screen stays where all triangles around it see it. */
void pel_frame_set_corner(struct pel_frame *frame, int i,
                          const struct pel_clip_corner *corner);

/* Is a side of the triangle seen that is to be drawn, and does its box reach
 * into the rectangle? */
bool pel_frame_shows(const struct pel_frame *frame,
                     const struct pel_point at[3], const struct pel_rect *rect);
PEL_END_DECLS
#endif
