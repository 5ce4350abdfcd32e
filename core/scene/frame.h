/* What a scene becomes on its way to pixels: for shadings and mappings. */
#ifndef PEL_SCENE_FRAME_H
#define PEL_SCENE_FRAME_H

#include "clip.h"
#include "depth.h"
#include "depth_sort.h"
#include "paint_perspective.h"
#include "paint_phong.h"

struct pel_scene;

struct pel_frame_vertex {
    struct pel_projected at;
    pel_color color; /* lit, where vertices are */
};

/* A corner of what is drawn: a vertex, or a place between three of them. */
struct pel_frame_corner {
    int32_t z;         /* coarse, >= the near plane */
    int32_t weight[3]; /* of the triangle's vertices, 2^-30 */
};

struct pel_frame_triangle {
    uint32_t vertex[3];
    struct pel_point at[3];
    struct pel_frame_corner corner[3];
    struct pel_plane_setup setup; /* ask pel_frame_setup for it */
    bool is_set_up;
};

/* Memory that is worked on: one triangle at a time. */
struct pel_frame_work {
    struct pel_surface surface;
    struct pel_frame_triangle triangle;
    struct pel_clip clip;
    union {
        struct pel_texture affine;
        struct pel_perspective perspective;
    } surface_paint;
    union {
        struct pel_flat flat;
        struct pel_gouraud gouraud;
        struct pel_tinted tinted;
        struct pel_phong phong;
    } paint;
    struct pel_depth_paint depth;
};

struct pel_frame {
    const struct pel_scene *scene;
    struct pel_projector projector;
    struct pel_mesh_lights lights;
    struct pel_texture texture; /* the sampler, without a map */
    struct pel_frame_vertex *vertex;
    struct pel_depth_entry *order;
    struct pel_frame_work *work;
    uint32_t triangles; /* in `order`: those that may be seen */
    uint8_t alpha;
    bool opaque;
    struct pel_mesh_fault fault; /* when an index is wrong */
};

/* The value of a corner from those of the vertices, |value| <= 2^30. */
static inline int32_t pel_corner_mix(const struct pel_frame_corner *corner,
                                     const int32_t value[3])
{
    for (int i = 0; i < 3; i++)
        if (corner->weight[i] == PEL_COSINE_ONE)
            return value[i];
    return (int32_t)pel_scale_down(pel_dot(corner->weight, value), 30);
}

/* What planes of the triangle share: made when it is first asked for. */
const struct pel_plane_setup *pel_frame_setup(
    struct pel_frame_triangle *triangle);

/* The planes of n values, value[i][k] that of vertex i: for n up to 3. */
void pel_frame_planes(struct pel_frame_triangle *triangle, int n,
                      int32_t value[3][3], struct pel_plane *plane);

/* Colours that are linear over the triangle: the planes of `paint`, which are
 * right to 2^-6 step. */
void pel_frame_gouraud(const struct pel_frame *frame, const pel_color color[3],
                       struct pel_gouraud *paint);

/* Does the box of a triangle reach into the rectangle? */
bool pel_frame_meets(const struct pel_point *at, const struct pel_rect *rect);

/* Colours of vertices at the corners. */
void pel_frame_colors(const struct pel_frame *frame,
                      const struct pel_frame_triangle *triangle,
                      pel_color color[3]);

#endif
