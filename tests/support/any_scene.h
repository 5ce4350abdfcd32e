/* Random scenes: a soup of triangles that a camera sees whole. */
#ifndef TESTS_SUPPORT_ANY_SCENE_H
#define TESTS_SUPPORT_ANY_SCENE_H

#include "canvas.h"
#include "cases.h"
#include "core/scene/pipeline.h"

enum {
    ANY_TRIANGLES = 40,
    ANY_VERTICES = 3 * ANY_TRIANGLES,
    ANY_LIGHTS = 3,
    ANY_TEXELS = 1024 /* a side */
};

/* Every triangle has vertices of its own: i has 3 i to 3 i + 2. */
struct any_scene {
    struct pel_scene scene;
    struct pel_mesh mesh;
    struct pel_pose pose;
    struct pel_lighting lighting;
    struct pel_light light[ANY_LIGHTS];
    struct pel_mesh_texture texture;
    int16_t positions[ANY_VERTICES][3], normals[ANY_VERTICES][3];
    uint16_t uv[ANY_VERTICES][2];
    uint8_t colors[ANY_VERTICES][3];
    uint8_t indices[ANY_TRIANGLES][3];
    uint64_t scratch[1024];
};

/* Pointers lead into the struct, so it must not be moved. Up to `pixels` wide
 * and high, anywhere within +-200 px; no texture; pel_shade_flat. */
void any_scene(struct random *r, struct any_scene *s, int32_t pixels);

/* Keeps it for failures (cases.h), as any_scene does. */
void any_scene_keep(const struct pel_scene *scene);

/* With light and normals of vertices that differ by an angle of some degrees.
 */
void any_scene_light(struct random *r, struct any_scene *s);

/* With u and v of random places in a texture of noise, of 2^bits texels a side;
 * bilinear, in perspective. */
void any_scene_noise(struct random *r, struct any_scene *s, int bits);

/* Where its mesh stands. */
static inline const struct pel_pose *any_scene_pose(const struct any_scene *s)
{
    return s->scene.pose ? s->scene.pose : &pel_pose_none;
}

/* Frames the scene; fails the test when it cannot. */
void any_scene_prepare(struct any_scene *s, struct pel_frame *frame);

/* Draws it so, on a canvas of its viewport; the frame is left prepared. */
void any_scene_draw(struct any_scene *s, const struct pel_shading *shading,
                    struct pel_frame *frame, struct canvas *canvas);

/* A shading whose colors are the number of the triangle plus 1. */
extern const struct pel_shading any_scene_numbers;

#endif
