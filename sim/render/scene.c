#include "sim/render/scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/scene/perspective.h"
#include "core/scene/work.h"
#include "sim/cli/message.h"

const struct scene_settings scene_default = {
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
    .terms = SCENE_ALL_TERMS,
    .shade = SCENE_GOURAUD,
    .texture = SCENE_TEXTURE_BILINEAR,
    .mapping = SCENE_MAP_PERSPECTIVE,
    .wrap = SCENE_WRAP_OWN,
    .span = 3,
};

bool scene_init(struct scene *scene, const struct model *model)
{
    memset(scene, 0, sizeof(*scene));
    scene->model = model;
    scene->mesh = model->mesh;
    scene->lighting.lights = SCENE_LIGHTS_MAX;
    scene->core.mesh = &scene->mesh;
    scene->core.lighting = &scene->lighting;
    scene->core.sort = &pel_depth_sort_radix;
    scene->scratch_size = pel_scene_scratch_size(&scene->core);
    scene->scratch = malloc(scene->scratch_size);
    scene->texture = calloc(model->textures + 1, sizeof(*scene->texture));
    scene->part = calloc(model->mesh.parts + 1, sizeof(*scene->part));
    return (scene->scratch && scene->texture && scene->part) ||
           message_error("no memory to draw %u vertices and %u triangles",
                         model->mesh.vertices, model->mesh.triangles);
}

void scene_free(struct scene *scene)
{
    free(scene->scratch);
    free(scene->texture);
    free(scene->part);
    scene->scratch = scene->texture = NULL;
    scene->part = NULL;
}

static void set_texture(struct pel_mesh_texture *to,
                        const struct model_texture *from,
                        const struct scene_settings *s)
{
    static const struct pel_mapping *const mappings[] = {
        &pel_map_vertices, &pel_map_affine, &pel_map_perspective,
        &pel_map_perspective};
    to->texels = (struct pel_texels){.colors = from->picture.pixels,
                                     .width = from->picture.width,
                                     .height = from->picture.height,
                                     .opaque = from->opaque};
    to->mapping = mappings[s->mapping];
    if (s->mapping == SCENE_MAP_PERSPECTIVE && s->texel_tolerance > 0)
        to->mapping = &pel_map_chosen;
    if (from->material.is_colored)
        to->mapping = scene_colored(to->mapping);
    to->sampler = s->texture == SCENE_TEXTURE_NEAREST
                      ? pel_texture_init_nearest
                      : pel_texture_init_bilinear;
    to->alpha =
        from->material.alpha == MESH_CUT_OUT ? pel_texture_cut_out : NULL;
    to->wrap_u = to->wrap_v = (enum pel_wrap)s->wrap;
    if (s->wrap == SCENE_WRAP_OWN) {
        to->wrap_u = from->material.wrap_u;
        to->wrap_v = from->material.wrap_v;
    }
    to->span = s->mapping == SCENE_MAP_SUBDIVIDED ? 2 << s->span : 1;
}

/* Textures, and parts in the color of the settings. Is some part without a
 * texture, and some translucent? */
static void set_parts(struct scene *scene, const struct scene_settings *s,
                      bool *bare, bool *clear)
{
    const struct model *model = scene->model;
    for (size_t i = 0; i < model->textures; i++)
        set_texture(&scene->texture[i], &model->texture[i], s);
    scene->core.textures = (uint32_t)model->textures;
    scene->core.texture =
        model->textures > 0 && s->texture != SCENE_TEXTURE_NONE ? scene->texture
                                                                : NULL;
    for (uint32_t i = 0; i < model->mesh.parts; i++) {
        struct pel_mesh_part *part = &scene->part[i];
        *part = model->mesh.part[i];
        if (!scene->core.texture)
            part->texture = 0;
        if (s->has_color)
            part->color = (s->color & 0xFFFFFFu) | (part->color & 0xFF000000u);
        *bare = *bare || !part->texture;
        *clear = *clear || pel_alpha(part->color) < 255 ||
                 (part->texture && !model->texture[part->texture - 1].opaque);
    }
    scene->mesh.part = scene->part;
}

static void set_appearance(struct scene *scene, const struct scene_settings *s)
{
    static const struct pel_shading *const shadings[][2][2] = {
        {{&pel_shade_flat, &pel_shade_lit_flat},
         {&pel_shade_flat, &pel_shade_lit_flat}},
        {{&pel_shade_gouraud, &pel_shade_lit_gouraud},
         {&pel_perspective_gouraud, &pel_perspective_lit_gouraud}},
        {{&pel_shade_phong, &pel_shade_phong},
         {&pel_perspective_phong, &pel_perspective_phong}}};
    struct pel_scene *core = &scene->core;
    bool bare = false, clear = s->transparency > 0;
    set_parts(scene, s, &bare, &clear);
    const bool shapeless = (scene->model->plain || s->has_color) && bare;
    const bool lit = s->lit == SCENE_LIT ||
                     (s->lit == SCENE_LIT_AUTO && (s->has_light || shapeless));
    core->shading = shadings[s->shade][s->in_world][lit];
    if (s->shade == SCENE_PHONG &&
        (s->show_methods || s->stats || s->tolerance > 0))
        core->shading = s->show_methods ? &scene_shade_methods
                        : s->stats      ? &scene_shade_counted
                        : s->in_world   ? &pel_perspective_chosen
                                        : &pel_shade_chosen;
    scene->methods = (struct scene_methods){.bound = 0};
    core->tolerance = (int32_t)lround(s->tolerance * 256);
    core->texel_tolerance = (int32_t)lround(s->texel_tolerance * 256);
    core->cull = s->cull;
    core->transparency = (uint8_t)s->transparency;
    core->color = s->color;
    if (s->has_color)
        scene->mesh.colors = NULL;
    /* Transparent triangles are blended from far to near. */
    core->sort = clear ? &pel_depth_sort_radix : NULL;
}

static enum pel_status prepare(struct scene *scene)
{
    return pel_scene_prepare(&scene->frame, &scene->core, scene->scratch,
                             scene->scratch_size);
}

/* Texture, camera and mesh are what is left that core may refuse. */
static bool refuse(struct scene *scene, const struct scene_settings *s,
                   enum pel_status status)
{
    const struct pel_texels *texels = &scene->texture[0].texels;
    const bool textured = scene->core.texture;
    scene->core.texture = NULL;
    if (textured && prepare(scene) != status)
        return message_error("texture coordinates lie beyond 262144 texels of "
                             "%dx%d: expected smaller ones",
                             texels->width, texels->height);
    if (status == PEL_ERROR_RANGE)
        return message_error("the near plane at %g is too close for a mesh so "
                             "far away, or the camera's place is out of range",
                             s->camera.near_plane);
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
    return message_error("the scene cannot be drawn (%s)",
                         pel_status_name(status));
}

bool scene_prepare(struct scene *scene, const struct scene_settings *settings)
{
    struct scene_settings s = *settings;
    if (s.shade == SCENE_PHONG && s.lit == SCENE_UNLIT)
        return message_error("Phong shading is light at every pixel: expected "
                             "flat or gouraud without light");
    if (!camera_frame(&s.camera, scene->model))
        return false;
    scene_place(scene, &s);
    set_appearance(scene, &s);
    scene_set_order(scene, &s);
    const enum pel_status status = prepare(scene);
    if (status != PEL_OK)
        return refuse(scene, &s, status);
    scene_prove_order(scene);
    return true;
}
