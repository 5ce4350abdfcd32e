/* A scene: a mesh, its camera, light, texture and settings. pipeline.h draws
 * it. */
#ifndef PEL_SCENE_SCENE_H
#define PEL_SCENE_SCENE_H

#include "../base/color.h"
#include "camera.h"

PEL_BEGIN_DECLS

struct pel_lighting;
struct pel_mesh_texture;
struct pel_shading;

/* Sides of triangles that are not drawn; the front shows the vertices
 * counter-clockwise. */
enum pel_cull { PEL_CULL_NONE, PEL_CULL_BACK, PEL_CULL_FRONT };

/* Of a triangle with that area (pel_triangle_area). */
static inline bool pel_side_drawn(enum pel_cull cull, int64_t area)
{
    return cull == PEL_CULL_NONE   ? area != 0
           : cull == PEL_CULL_BACK ? area < 0
                                   : area > 0;
}

struct pel_depth_entry {
    int32_t depth; /* any number that grows with the distance */
    uint32_t index;
};

/* Sorts entries, whose indices rise, by falling depth, equal depths by rising
 * index, so the result is the same on every CPU; without recursion. */
struct pel_depth_sort {
    void (*sort)(struct pel_depth_entry *entry, uint32_t n,
                 struct pel_depth_entry *spare);
    bool needs_spare; /* of n entries, from the scratch memory of a frame */
};

/* In place, at most about 2 n log2(n) comparisons for any input. */
extern const struct pel_depth_sort pel_depth_sort;

/* Six passes for any input: several times as fast for thousands of triangles,
 * with 8 bytes of scratch memory more for each. */
extern const struct pel_depth_sort pel_depth_sort_radix;

/* All of it is the caller's, and stays while frames of it are drawn. */
struct pel_scene {
    const struct pel_mesh *mesh;
    const struct pel_pose *pose; /* NULL: pel_pose_none */
    struct pel_camera camera;
    struct pel_rect viewport; /* px; nothing is drawn outside */

    const struct pel_shading *shading;   /* shading.h */
    const struct pel_lighting *lighting; /* light.h; for shadings with light */
    const struct pel_mesh_texture *texture; /* mapping.h; NULL: no texture */
    uint32_t textures;    /* in that array, 0 as 1; parts name them by number,
                             from 1 on */
    pel_color color;      /* of a mesh without colors and parts, as if its
                             alpha were 255 */
    uint8_t transparency; /* 0: opaque; 255: nothing is drawn */

    enum pel_cull cull;

    /* For methods that are chosen (select.h); 0: they are exact. How far a
     * channel may be from that of the exact method, before it is packed: so
     * many 1/256 steps, rounded up to whole ones. */
    int32_t tolerance;
    int32_t texel_tolerance; /* how far a place in a texture may be off, 1/256
                                texel; `tolerance` is from the color there */

    /* &pel_depth_sort or another one for painter's order, from the farthest to
     * the nearest, by the exact sum of the depths of three vertices. NULL: the
     * order of the mesh, for depth buffers. */
    const struct pel_depth_sort *sort;
};

PEL_END_DECLS
#endif
