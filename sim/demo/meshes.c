/* The demos of meshes: a mesh painted back to front, with a texture, and with
 * lights. The mesh is the duck of assimp-testmodels, or the built-in vase where
 * that is missing. */
#include <stdio.h>
#include <math.h>
#include <stdarg.h>
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

enum system { PAINTED, TEXTURED, LIT };

/* What is shown of the mesh, by which system. */
struct look {
    enum system system;
    enum scene_shade shade;
    enum scene_texture texture;
    enum scene_mapping mapping;
    enum scene_lit lit;
    unsigned terms;
    int light; /* of three, counted from 1; 0: all */
};

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

/* A board for a model without a texture. */
static bool add_board(struct model *model)
{
    struct picture board;
    if (model->textures > 0)
        return true;
    if (!model->mesh.uv)
        return message_error("the mesh has no texture coordinates");
    if (!picture_init(&board, 256, 256, 0))
        return false;
    draw_board(&board);
    return model_set_picture(model, &board);
}

static bool make(struct model *model, const struct mesh *mesh,
                 const struct model_source *source, bool board)
{
    if (model_make(model, mesh, 0) && model_add_textures(model, mesh, source) &&
        (!board || add_board(model)))
        return true;
    model_free(model);
    return false;
}

/* The rule of TEXTURED alone: nearest takes column floor(u (W - 1)) and row
 * floor(v (H - 1)). The size of the texture is known when it has been read. */
static bool scale_uv(struct model *model, struct mesh *mesh,
                     const struct model_source *source)
{
    const double w = model->texture->picture.width;
    const double h = model->texture->picture.height;
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        mesh->vertex[i].uv[0] *= (w - 1) / w;
        mesh->vertex[i].uv[1] *= (h - 1) / h;
    }
    model_free(model);
    return make(model, mesh, source, true);
}

/* The mesh with its own texture, and with a board in place of none; the note
 * says which they are. */
static bool load(struct model *model, enum system system, char *path,
                 size_t size, struct demo_result *result)
{
    struct mesh mesh;
    const struct model_source source = {.path = path};
    const char *models = getenv("PEL_MODELS");
    snprintf(path, size, "%s/%s", models ? models : MODELS, DUCK);
    const bool is_there = access(path, R_OK) == 0;
    const bool is_duck = is_there && mesh_files_supported();
    if (!is_duck)
        snprintf(path, size, "%s", MESH_BUILTIN);
    if (!mesh_load(&mesh, path))
        return false;
    const bool done = make(model, &mesh, &source, system != PAINTED) &&
                      (system != TEXTURED || scale_uv(model, &mesh, &source));
    const bool board = system != PAINTED && mesh.textures == 0;
    mesh_free(&mesh);
    snprintf(result->note, sizeof(result->note), "%s%s%s.%s",
             is_duck ? "The mesh is "
                     : "The built-in vase stands in for the duck: ",
             is_duck    ? DUCK " of assimp-testmodels"
             : is_there ? "libassimp-dev (at build time)"
                        : "the package assimp-testmodels",
             is_duck ? "" : " is missing",
             board ? " Its texture is a generated board." : "");
    return done;
}

struct drawing {
    struct scene *scene;
    const struct scene_settings *settings;
};

/* The time is that of clearing, preparing and drawing. */
static bool draw_scene(struct canvas *canvas, const void *context)
{
    const struct drawing *d = context;
    pel_clear(&canvas->surface, d->settings->camera.background);
    return scene_prepare(d->scene, d->settings) &&
           scene_draw(d->scene, &canvas->surface);
}

/* Three lights around the mesh, its size away from its middle: warm from the
 * right and above, blue from the left, red from behind and above. Rounded, so
 * that they can be told. */
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
        if (only && only != i + 1)
            continue;
        struct scene_light *light = &s->light[s->lights++];
        *light = around[i];
        for (int k = 0; k < 3; k++)
            light->at[k] = rint(1000 * ((model->low[k] + model->high[k]) / 2 +
                                        size * around[i].at[k])) /
                           1000;
    }
}

static struct scene_settings settings_of(const struct look *look,
                                         const struct model *model)
{
    static const int sizes[] = {1200, 512, 480};
    struct scene_settings s = scene_default;
    s.camera.width = s.camera.height = sizes[look->system];
    s.shade = look->shade;
    s.texture = look->texture;
    s.mapping = look->mapping;
    s.lit = look->lit;
    if (look->system != LIT)
        return s;
    s.camera.background = PEL_RGB(24, 26, 32);
    s.ambient = 0.2;
    s.specular = 0.5;
    s.shininess = 24;
    s.terms = look->terms;
    set_lights(&s, model, look->light);
    return s;
}

static void tell(struct demo_result *result, const char *format, ...)
{
    const size_t n = strlen(result->command);
    va_list values;
    va_start(values, format);
    vsnprintf(result->command + n, sizeof result->command - n, format, values);
    va_end(values);
}

static void tell_light(struct demo_result *result, const struct look *look,
                       const struct scene_settings *s)
{
    static const struct {
        unsigned terms;
        const char *name;
    } parts[] = {{SCENE_AMBIENT, "ambient"},
                 {SCENE_DIFFUSE, "diffuse"},
                 {SCENE_SPECULAR, "specular"}};
    if (look->lit == SCENE_UNLIT) {
        tell(result, " --unlit");
        return;
    }
    tell(result, " --ka %g --ks %g --shininess %d", s->ambient, s->specular,
         s->shininess);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        if (look->terms == parts[i].terms)
            tell(result, " --terms %s", parts[i].name);
    for (int i = 0; i < s->lights; i++) {
        const struct scene_light *l = &s->light[i];
        tell(result, " --light %.10g,%.10g,%.10g:%g,%g,%g", l->at[0], l->at[1],
             l->at[2], l->color[0], l->color[1], l->color[2]);
    }
}

/* The command that draws the same; of TEXTURED, whose texels have a rule of
 * their own, and of a board, which no file has, there is none. */
static void tell_command(struct demo_result *result, const struct look *look,
                         const struct scene_settings *s, const char *path)
{
    static const char *const shades[] = {"flat", "gouraud", "phong"};
    static const char *const textures[] = {"none", "nearest", "bilinear"};
    static const char *const mappings[] = {"vertices", "affine", "subdivided",
                                           "perspective"};
    if (look->system == TEXTURED || strstr(result->note, "generated board"))
        return;
    tell(result, "pel render %s --size %dx%d --shade %s --texture %s", path,
         s->camera.width, s->camera.height, shades[look->shade],
         textures[look->texture]);
    if (look->texture != SCENE_TEXTURE_NONE)
        tell(result, " --mapping %s", mappings[look->mapping]);
    if (look->system != LIT)
        return;
    tell(result, " --background '#%06lx'",
         (unsigned long)(s->camera.background & 0xFFFFFF));
    tell_light(result, look, s);
}

static bool draw(struct demo_result *result, const void *what)
{
    char path[4096];
    const struct look *look = what;
    struct model model;
    struct scene scene;
    if (!load(&model, look->system, path, sizeof path, result))
        return false;
    const struct scene_settings settings = settings_of(look, &model);
    tell_command(result, look, &settings, path);
    const struct drawing drawing = {&scene, &settings};
    const struct demo_size size = {&pel_xrgb8888, settings.camera.width,
                                   settings.camera.height};
    const bool done = scene_init(&scene, &model) &&
                      demo_draw(result, &size, draw_scene, &drawing);
    scene_free(&scene);
    model_free(&model);
    return done;
}

#define LOOK(system, shade, texture, mapping, lit, terms, light)             \
    NULL, draw, &(const struct look)                                         \
    {                                                                        \
        system, SCENE_##shade, SCENE_TEXTURE_##texture, SCENE_MAP_##mapping, \
            SCENE_##lit, terms, light                                        \
    }
#define BOTH(name, caption, terms, light)                                     \
    {"lighting-gouraud" name,                                                 \
     "Light and texture at the vertices, the colours interpolated: " caption, \
     LOOK(LIT, GOURAUD, BILINEAR, VERTICES, LIT, terms, light)},              \
    {                                                                         \
        "lighting-phong" name,                                                \
            "Light and texture at every pixel, the normal "                   \
            "interpolated: " caption,                                         \
            LOOK(LIT, PHONG, BILINEAR, PERSPECTIVE, LIT, terms, light)        \
    }

const struct demo demo_meshes[] = {
    {"duck-flat",
     "A mesh painted back to front, one colour per triangle: the mean of its "
     "three vertices.",
     LOOK(PAINTED, FLAT, NEAREST, VERTICES, LIT_AUTO, 0, 0)},
    {"duck-gouraud",
     "The same triangles with the colours of their vertices interpolated.",
     LOOK(PAINTED, GOURAUD, NEAREST, VERTICES, LIT_AUTO, 0, 0)},
    {"texture-flat",
     "Triangles in one colour each: the mean of the texels at their vertices.",
     LOOK(TEXTURED, FLAT, NEAREST, VERTICES, UNLIT, 0, 0)},
    {"texture-nearest",
     "The texture on every triangle, the nearest texel for each pixel. What "
     "that does to enlarged texels, the scenes textures and meshes show.",
     LOOK(TEXTURED, GOURAUD, NEAREST, AFFINE, UNLIT, 0, 0)},
    {"texture-bilinear", "A texture: the four texels around a point, mixed.",
     LOOK(TEXTURED, GOURAUD, BILINEAR, AFFINE, UNLIT, 0, 0)},
    BOTH("", "three lights, all terms.", SCENE_ALL_TERMS, 0),
    BOTH("-ambient", "the ambient term.", SCENE_AMBIENT, 0),
    BOTH("-diffuse", "the diffuse term.", SCENE_DIFFUSE, 0),
    BOTH("-specular", "the specular term.", SCENE_SPECULAR, 0),
    BOTH("-light1", "light 1 alone.", SCENE_ALL_TERMS, 1),
    BOTH("-light2", "light 2 alone.", SCENE_ALL_TERMS, 2),
    BOTH("-light3", "light 3 alone.", SCENE_ALL_TERMS, 3),
    {"lighting-texture-vertices", "The texture alone, at the vertices.",
     LOOK(LIT, GOURAUD, BILINEAR, VERTICES, UNLIT, 0, 0)},
    {"lighting-texture-pixels", "The texture alone, at every pixel.",
     LOOK(LIT, GOURAUD, BILINEAR, PERSPECTIVE, UNLIT, 0, 0)},
    {"lighting-gouraud-plain", "Gouraud without the texture.",
     LOOK(LIT, GOURAUD, NONE, VERTICES, LIT, SCENE_ALL_TERMS, 0)},
    {"lighting-phong-plain", "Phong without the texture.",
     LOOK(LIT, PHONG, NONE, PERSPECTIVE, LIT, SCENE_ALL_TERMS, 0)},
    {NULL, NULL, NULL, NULL, NULL},
};
