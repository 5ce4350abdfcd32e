#include "stage.h"

#include <stdlib.h>
#include <string.h>

#include "message.h"
#include "stage_world.h"

const struct stage_settings stage_default = {
    .camera = {.up = {0, 1, 0},
               .focal = 50,
               .sensor = {36, 0},
               .width = 1200,
               .height = 1200,
               .background = PEL_RGB(255, 255, 255)},
    .ambient_color = {1, 1, 1},
    .ambient = 0.3,
    .diffuse = 0.7,
    .specular = 0.3,
    .shininess = 20,
    .terms = STAGE_ALL_TERMS,
    .shade = STAGE_GOURAUD,
    .texture = STAGE_TEXTURE_BILINEAR,
    .mapping = STAGE_MAP_PERSPECTIVE,
    .wrap = PEL_WRAP_REPEAT,
    .span = 16,
};

bool stage_init(struct stage *stage, const struct model *model)
{
    memset(stage, 0, sizeof(*stage));
    stage->model = model;
    stage->mesh = model->mesh;
    stage->lighting.lights = STAGE_LIGHTS_MAX;
    stage->scene.mesh = &stage->mesh;
    stage->scene.lighting = &stage->lighting;
    stage->scratch_size = pel_scene_scratch_size(&stage->scene);
    stage->scratch = malloc(stage->scratch_size);
    return stage->scratch ||
           message_error("no memory to draw %u vertices and %u triangles",
                         model->mesh.vertices, model->mesh.triangles);
}

void stage_free(struct stage *stage)
{
    free(stage->scratch);
    stage->scratch = NULL;
}

static void set_texture(struct stage *stage, const struct stage_settings *s)
{
    static const struct pel_mapping *const mappings[] = {
        &pel_map_vertices, &pel_map_affine, &pel_map_perspective,
        &pel_map_perspective};
    struct pel_mesh_texture *to = &stage->texture;
    const struct picture *picture = &stage->model->texture;
    to->texels = (struct pel_texels){.colors = picture->pixels,
                                     .width = picture->width,
                                     .height = picture->height,
                                     .opaque = stage->model->texture_opaque};
    to->mapping = mappings[s->mapping];
    to->sampler = s->texture == STAGE_TEXTURE_NEAREST
                      ? pel_texture_init_nearest
                      : pel_texture_init_bilinear;
    to->wrap_u = to->wrap_v = s->wrap;
    to->span = s->mapping == STAGE_MAP_SUBDIVIDED ? s->span : 1;
    const bool has_texture =
        picture->width > 0 && s->texture != STAGE_TEXTURE_NONE;
    stage->scene.texture = has_texture ? to : NULL;
}

static bool is_lit(const struct stage *stage, const struct stage_settings *s)
{
    const bool shapeless =
        (stage->model->plain || s->has_color) && !stage->scene.texture;
    return s->shade == STAGE_PHONG || s->lit == STAGE_LIT ||
           (s->lit == STAGE_LIT_AUTO && (s->has_light || shapeless));
}

static void set_look(struct stage *stage, const struct stage_settings *s)
{
    static const struct pel_shading *const shadings[][2] = {
        {&pel_shade_flat, &pel_shade_lit_flat},
        {&pel_shade_gouraud, &pel_shade_lit_gouraud},
        {&pel_shade_phong, &pel_shade_phong}};
    struct pel_scene *scene = &stage->scene;
    set_texture(stage, s);
    scene->shading = shadings[s->shade][is_lit(stage, s)];
    scene->cull = s->cull;
    scene->transparency = s->transparency;
    scene->color = s->color;
    if (s->has_color)
        stage->mesh.colors = NULL;
    stage->depth_bits = s->order == STAGE_ZBUFFER16   ? 16
                        : s->order == STAGE_ZBUFFER32 ? 32
                                                      : 0;
    /* What can be seen through is blended from far to near in any order. */
    const bool clear = s->transparency > 0 ||
                       (scene->texture && !stage->model->texture_opaque);
    scene->sort = stage->depth_bits == 0 || clear ? pel_depth_sort : NULL;
}

static bool check(const struct stage_settings *s)
{
    return s->shade != STAGE_PHONG || s->lit != STAGE_UNLIT ||
           message_error("Phong shading is light at every pixel; without "
                         "light, flat or gouraud would be right");
}

/* Camera and mesh are what is left that core may refuse. */
static bool refuse(const struct stage_settings *s, enum pel_status status)
{
    if (status == PEL_ERROR_RANGE)
        return message_error("the near plane at %g is too close for a mesh so "
                             "far away, or the camera's place is out of range",
                             s->camera.near);
    if (status == PEL_ERROR_SIZE && s->camera.projection == PEL_PERSPECTIVE)
        return message_error("focal length %g and sensor %gx%g make more than "
                             "65536 or less than 1/256 pixel of a unit at "
                             "distance 1, or the mesh is too small or large "
                             "for its distance",
                             s->camera.focal, s->camera.sensor[0],
                             s->camera.sensor[1]);
    if (status == PEL_ERROR_SIZE)
        return message_error("a sensor of %gx%g makes more than 65536 or less "
                             "than 1/256 pixel of a unit",
                             s->camera.sensor[0], s->camera.sensor[1]);
    return message_error("the scene cannot be drawn (status %d)", status);
}

bool stage_prepare(struct stage *stage, const struct stage_settings *settings)
{
    struct stage_settings s = *settings;
    if (!check(&s) || !camera_frame(&s.camera, stage->model))
        return false;
    stage_place(stage, &s);
    stage_place_lights(stage, &s);
    set_look(stage, &s);
    const enum pel_status status = pel_scene_prepare(
        &stage->frame, &stage->scene, stage->scratch, stage->scratch_size);
    return status == PEL_OK || refuse(&s, status);
}

static bool draw_depth(const struct stage *stage, struct pel_frame *frame,
                       const struct pel_surface *surface)
{
    struct pel_depth depth;
    const struct pel_rect bounds =
        pel_rect_intersect(&surface->clip, &stage->scene.viewport);
    const size_t size = pel_depth_size(&bounds, stage->depth_bits);
    if (size == 0) /* nothing is seen */
        return true;
    void *memory = malloc(size);
    if (!memory)
        return message_error("no memory for a depth buffer of %zu bytes", size);
    const enum pel_status status =
        pel_depth_init(&depth, &bounds, stage->depth_bits, memory, size);
    if (status == PEL_OK)
        pel_scene_draw_depth(frame, surface, &depth);
    free(memory);
    return status == PEL_OK ||
           message_error("no depth buffer (status %d)", status);
}

/* Vertices and order are only read; the rest is this call's own. */
bool stage_draw(const struct stage *stage, const struct pel_surface *surface)
{
    struct pel_frame frame = stage->frame;
    struct pel_frame_work work;
    frame.work = &work;
    if (stage->depth_bits > 0)
        return draw_depth(stage, &frame, surface);
    pel_scene_draw(&frame, surface);
    return true;
}
