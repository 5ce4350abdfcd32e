/* The mesh, the light and the camera of the smallest programs in 3-D. One
 * vertex lies behind the eye, so that triangles are cut. */
#ifndef TESTS_LINK_SCENE_H
#define TESTS_LINK_SCENE_H

#include "core/scene/pipeline.h"
#include "core/scene/mapping.h"
#include "screen.h"

static const int16_t positions[4][3] = {
    {-1000, 0, 0}, {1000, 0, 0}, {0, 1000, 0}, {0, 0, -4000}};
static const int8_t normals[4][3] = {
    {0, 0, -127}, {0, 0, -127}, {0, 127, 0}, {0, 0, -127}};
static const uint8_t indices[4][3] = {
    {0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};

static const uint16_t scene_uv[4][2] = {
    {0, 0}, {65535, 0}, {0, 65535}, {32768, 32768}};
static const pel_color scene_texels[4] = {PEL_RGB(255, 0, 0),
                                          PEL_RGB(0, 255, 0),
                                          PEL_RGB(0, 0, 255), PEL_RGB(9, 9, 9)};

#define SCENE_TEXTURE(mapping_of_texture)                \
    {                                                    \
        .texels = {.colors = scene_texels,               \
                   .width = 2,                           \
                   .height = 2,                          \
                   .opaque = true},                      \
        .mapping = &(mapping_of_texture),                \
        .sampler = pel_texture_init_bilinear, .span = 16 \
    }

#define SCENE_MESH(places_of_texels)                                       \
    {                                                                      \
        .vertices = 4, .triangles = 4, .position = {{0, 0, 0}, 1, 10},     \
        .texture = {{0, 0, 0}, 1, 16}, .positions = positions,             \
        .normals8 = normals, .uv = (places_of_texels), .indices8 = indices \
    }

static const struct pel_light scene_light = {
    .at = {0, PEL_UNITS(3), -PEL_UNITS(3)}, .color = {65536, 65536, 65536}};
static const struct pel_lighting scene_lighting = {
    .light = &scene_light,
    .lights = 1,
    .ambient_color = {65536, 65536, 65536},
    .ambient = PEL_FACTOR(20),
    .diffuse = PEL_FACTOR(60),
    .specular = PEL_FACTOR(40),
    .shininess = 20};

#define SCENE(mesh_of_scene, shading_of_scene)                       \
    {                                                                \
        .mesh = &(mesh_of_scene),                                    \
        .camera = {.eye = {0, 0, -PEL_UNITS(3)},                     \
                   .up = {0, 1, 0},                                  \
                   .near_plane = PEL_UNITS(1) / 16,                  \
                   .focal = 50,                                      \
                   .sensor = {36, 36}},                              \
        .viewport = {0, 0, SCREEN_SIDE, SCREEN_SIDE},                \
        .shading = &(shading_of_scene), .lighting = &scene_lighting, \
        .color = PEL_RGB(200, 200, 200), .sort = &pel_depth_sort     \
    }

static inline int scene_show(const struct pel_scene *scene)
{
    static const struct pel_surface screen = SCREEN(pel_rgb565_le);
    static uint64_t scratch[250];
    static struct pel_frame frame;
    const enum pel_status status =
        pel_scene_prepare(&frame, scene, scratch, sizeof scratch);
    if (status == PEL_OK)
        pel_scene_draw(&frame, &screen);
    return status;
}

#endif
