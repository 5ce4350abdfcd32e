/* The demos of meshes: a mesh painted back to front, with a texture, and with
 * lights. The mesh is the duck of assimp-testmodels, or the built-in vase where
 * that is missing. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/format/formats.h"
#include "core/raster/rectangle.h"
#include "sim/cli/message.h"
#include "sim/demo/demo.h"
#include "sim/render/scene.h"

/* The models of Debian's package assimp-testmodels; the variable
 * PEL_MODELS names another directory. */
#define MODELS "/usr/share/assimp/models"
#define DUCK "Collada/duck.dae"

/* The mesh before it is quantised; `source` names its file (the path is
 * good until the next call), and so does the result's note. */
static bool load_mesh(struct mesh *mesh, struct model_source *source,
                      struct demo_result *result)
{
    static char path[4096];
    const char *models = getenv("PEL_MODELS");
    snprintf(path, sizeof(path), "%s/%s", models ? models : MODELS, DUCK);
    const bool is_there = access(path, R_OK) == 0;
    *source = (struct model_source){.path = path};
    if (is_there && mesh_files_supported()) {
        snprintf(result->note, sizeof(result->note),
                 "The mesh is %s of assimp-testmodels.", DUCK);
    } else {
        snprintf(path, sizeof(path), "%s", MESH_BUILTIN);
        snprintf(result->note, sizeof(result->note),
                 "The built-in vase stands in for the duck: %s is missing.",
                 is_there ? "libassimp-dev (at build time)"
                          : "the package assimp-testmodels");
    }
    return mesh_load(mesh, path);
}

/* A board of 16 by 16 squares, brighter towards its middle row. */
static void draw_board(const struct picture *picture)
{
    for (int y = 0; y < picture->height; y++) {
        const int distance = abs(2 * y - picture->height);
        const int gain = 255 - 128 * distance / picture->height;
        for (int x = 0; x < picture->width; x++) {
            const bool dark = (x / 16 + y / 16) % 2 != 0;
            const int red = dark ? 40 : 240, blue = dark ? 160 : 224;
            picture_row(picture, y)[x] =
                PEL_RGB(red * gain / 255, (red + blue) / 2 * gain / 255,
                        blue * gain / 255);
        }
    }
}

/* A board for a model without a texture; the note says so. */
static bool add_board(struct model *model, struct demo_result *result)
{
    const size_t length = strlen(result->note);
    struct picture board;
    if (model->textures > 0)
        return true;
    if (!model->mesh.uv)
        return message_error("the mesh has no texture coordinates");
    if (!picture_init(&board, 256, 256, 0))
        return false;
    draw_board(&board);
    if (!model_set_picture(model, &board))
        return false;
    snprintf(result->note + length, sizeof(result->note) - length,
             " Its texture is a generated board.");
    return true;
}

/* The mesh with its own texture, and with a board in place of none. */
static bool load_model(struct model *model, bool board,
                       struct demo_result *result)
{
    struct model_source source;
    struct mesh mesh;
    if (!load_mesh(&mesh, &source, result))
        return false;
    const bool done = model_make(model, &mesh) &&
                      model_add_textures(model, &mesh, &source) &&
                      (!board || add_board(model, result));
    mesh_free(&mesh);
    if (!done)
        model_free(model);
    return done;
}

struct drawing {
    struct scene *scene;
    const struct scene_settings *settings;
};

static bool draw_scene(struct canvas *canvas, const void *context)
{
    const struct drawing *d = context;
    pel_clear(&canvas->surface, d->settings->camera.background);
    return scene_prepare(d->scene, d->settings) &&
           scene_draw(d->scene, &canvas->surface);
}

/* The time is that of clearing, preparing and drawing. */
static bool draw_model(const struct model *model,
                       const struct scene_settings *settings,
                       struct demo_result *result)
{
    struct scene scene;
    const struct drawing drawing = {&scene, settings};
    const struct demo_size size = {&pel_xrgb8888, settings->camera.width,
                                   settings->camera.height};
    const bool done = scene_init(&scene, model) &&
                      demo_draw(result, &size, draw_scene, &drawing);
    scene_free(&scene);
    return done;
}

/* SCENE_FLAT or SCENE_GOURAUD, with the colors of the texture at vertices. */
static bool draw_duck(struct demo_result *result, int shade)
{
    struct model model;
    struct scene_settings settings = scene_default;
    settings.camera.width = settings.camera.height = 1200;
    settings.shade = (enum scene_shade)shade;
    settings.texture = SCENE_TEXTURE_NEAREST;
    settings.mapping = SCENE_MAP_VERTICES;
    if (!load_model(&model, false, result))
        return false;
    const bool done = draw_model(&model, &settings, result);
    model_free(&model);
    return done;
}

const struct demo demo_duck[] = {
    {"duck-flat",
     "A mesh painted back to front, one colour per triangle: the mean of its "
     "three vertices.",
     draw_duck, SCENE_FLAT},
    {"duck-gouraud",
     "The same triangles with the colours of their vertices interpolated.",
     draw_duck, SCENE_GOURAUD},
    {NULL, NULL, NULL, 0},
};

/* The rule of this demo alone: nearest takes column floor(u (W - 1)) and row
 * floor(v (H - 1)). */
static void scale_uv(struct mesh *mesh, const struct picture *texture)
{
    const double w = texture->width, h = texture->height;
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        mesh->vertex[i].uv[0] *= (w - 1) / w;
        mesh->vertex[i].uv[1] *= (h - 1) / h;
    }
}

/* The size of the texture is known when it has been read; then the mesh is
 * quantised once more, with what that scales. */
static bool make_scaled(struct model *model, struct mesh *mesh,
                        const struct model_source *source,
                        struct demo_result *result)
{
    struct model scaled;
    if (!model_make(model, mesh) || !model_add_textures(model, mesh, source) ||
        !add_board(model, result))
        return false;
    scale_uv(mesh, &model->texture[0].picture);
    if (!model_make(&scaled, mesh))
        return false;
    const struct pel_mesh_part *part = scaled.mesh.part;
    scaled.mesh.part = model->mesh.part;
    scaled.texture = model->texture;
    scaled.textures = model->textures;
    model->mesh.part = part;
    model->textures = 0;
    model->texture = NULL;
    model_free(model);
    *model = scaled;
    return true;
}

static struct scene_settings texture_settings(int texture)
{
    const bool is_flat = texture == SCENE_TEXTURE_NONE;
    struct scene_settings s = scene_default;
    s.camera.width = s.camera.height = 512;
    s.lit = SCENE_UNLIT;
    s.shade = is_flat ? SCENE_FLAT : SCENE_GOURAUD;
    s.mapping = is_flat ? SCENE_MAP_VERTICES : SCENE_MAP_AFFINE;
    s.texture = is_flat ? SCENE_TEXTURE_NEAREST : (enum scene_texture)texture;
    return s;
}

static bool draw_texture(struct demo_result *result, int texture)
{
    struct model_source source;
    struct model model = {.plain = true};
    struct mesh mesh;
    const struct scene_settings settings = texture_settings(texture);
    if (!load_mesh(&mesh, &source, result))
        return false;
    const bool done = make_scaled(&model, &mesh, &source, result) &&
                      draw_model(&model, &settings, result);
    model_free(&model);
    mesh_free(&mesh);
    return done;
}

const struct demo demo_texture[] = {
    {"texture-flat",
     "Triangles in one colour each: the mean of the texels at their vertices.",
     draw_texture, SCENE_TEXTURE_NONE},
    {"texture-nearest",
     "The texture on every triangle, the nearest texel for each pixel. What "
     "that does to enlarged texels, the scenes textures and meshes show.",
     draw_texture, SCENE_TEXTURE_NEAREST},
    {"texture-bilinear", "The same with the four texels around it mixed.",
     draw_texture, SCENE_TEXTURE_BILINEAR},
    {NULL, NULL, NULL, 0},
};

/* Three lights around the mesh, its size away from its middle: warm from the
 * right and above, blue from the left, red from behind and above. */
static void set_lights(struct scene_settings *s, const struct model *model,
                       int only)
{
    static const struct scene_light around[3] = {
        {{1.2, 1.2, 1.6}, {1, 0.95, 0.8}, false},
        {{-2, 0.4, 0.8}, {0.25, 0.45, 1}, false},
        {{0.3, 1.5, -1.8}, {1, 0.35, 0.25}, false}};
    double size = 0;
    for (int k = 0; k < 3; k++)
        if (model->high[k] - model->low[k] > size)
            size = model->high[k] - model->low[k];
    for (int i = 0; i < 3; i++) {
        if (only >= 0 && only != i)
            continue;
        struct scene_light *light = &s->light[s->lights++];
        *light = around[i];
        for (int k = 0; k < 3; k++)
            light->at[k] =
                (model->low[k] + model->high[k]) / 2 + size * around[i].at[k];
    }
}

/* The pictures 0 to 6 are Gouraud's and 7 to 13 Phong's: all of it, term by
 * term, light by light (-1: all). Then, either way each, the texture alone and
 * the light alone. */
static struct scene_settings lighting_settings(int which,
                                               const struct model *model)
{
    static const struct {
        unsigned terms;
        int light;
    } parts[7] = {
        {SCENE_ALL_TERMS, -1}, {SCENE_AMBIENT, -1},  {SCENE_DIFFUSE, -1},
        {SCENE_SPECULAR, -1},  {SCENE_ALL_TERMS, 0}, {SCENE_ALL_TERMS, 1},
        {SCENE_ALL_TERMS, 2},
    };
    const int part = which < 14 ? which % 7 : 0;
    const bool is_phong = which < 14 ? which >= 7 : which % 2 != 0;
    const bool is_unlit = which == 14 || which == 15;
    struct scene_settings s = scene_default;
    s.camera.width = s.camera.height = 480;
    s.camera.background = PEL_RGB(24, 26, 32);
    s.shade = is_phong && !is_unlit ? SCENE_PHONG : SCENE_GOURAUD;
    s.lit = is_unlit ? SCENE_UNLIT : SCENE_LIT;
    s.ambient = 0.2;
    s.specular = 0.5;
    s.shininess = 24;
    s.terms = parts[part].terms;
    s.texture = which < 16 ? SCENE_TEXTURE_BILINEAR : SCENE_TEXTURE_NONE;
    s.mapping = is_phong ? SCENE_MAP_PERSPECTIVE : SCENE_MAP_VERTICES;
    set_lights(&s, model, parts[part].light);
    return s;
}

static bool draw_lighting(struct demo_result *result, int which)
{
    struct model model;
    if (!load_model(&model, true, result))
        return false;
    const struct scene_settings settings = lighting_settings(which, &model);
    const bool done = draw_model(&model, &settings, result);
    model_free(&model);
    return done;
}

#define GOURAUD "Light and texture at the vertices, the colours interpolated"
#define PHONG "Light and texture at every pixel, the normal interpolated"

#define PICTURE(name, caption, which)                   \
    {                                                   \
        "lighting-" name, caption, draw_lighting, which \
    }
#define LIGHTING(name, how, first)                                        \
    PICTURE(name, how ": three lights, all terms.", first),               \
        PICTURE(name "-ambient", how ": the ambient term.", first + 1),   \
        PICTURE(name "-diffuse", how ": the diffuse term.", first + 2),   \
        PICTURE(name "-specular", how ": the specular term.", first + 3), \
        PICTURE(name "-light1", how ": light 1 alone.", first + 4),       \
        PICTURE(name "-light2", how ": light 2 alone.", first + 5),       \
        PICTURE(name "-light3", how ": light 3 alone.", first + 6)

const struct demo demo_lighting[] = {
    LIGHTING("gouraud", GOURAUD, 0),
    LIGHTING("phong", PHONG, 7),
    PICTURE("texture-vertices", "The texture alone, at the vertices.", 14),
    PICTURE("texture-pixels", "The texture alone, at every pixel.", 15),
    PICTURE("gouraud-plain", "Gouraud without the texture.", 16),
    PICTURE("phong-plain", "Phong without the texture.", 17),
    {NULL, NULL, NULL, 0},
};
