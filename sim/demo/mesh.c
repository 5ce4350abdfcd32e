#include "sim/demo/mesh.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sim/image/canvas.h"
#include "core/format/formats.h"
#include "core/raster/rectangle.h"
#include "sim/cli/message.h"
#include "sim/cli/milliseconds.h"

/* Where Debian's package assimp-testmodels has its models; the variable
 * PEL_MODELS names another directory. */
#define MODELS "/usr/share/assimp/models"
#define DUCK "Collada/duck.dae"

bool demo_mesh_load(struct mesh *mesh, struct model_source *source,
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
        const int far = abs(2 * y - picture->height);
        const int gain = 255 - 128 * far / picture->height;
        for (int x = 0; x < picture->width; x++) {
            const bool dark = (x / 16 + y / 16) % 2 != 0;
            const int red = dark ? 40 : 240, blue = dark ? 160 : 224;
            picture_row(picture, y)[x] =
                PEL_RGB(red * gain / 255, (red + blue) / 2 * gain / 255,
                        blue * gain / 255);
        }
    }
}

bool demo_mesh_add_texture(struct model *model, struct demo_result *result)
{
    const size_t length = strlen(result->note);
    if (model->texture.width > 0)
        return true;
    if (!model->mesh.uv)
        return message_error("the mesh has no texture coordinates");
    if (!picture_init(&model->texture, 256, 256, 0))
        return false;
    draw_board(&model->texture);
    model->texture_opaque = true;
    snprintf(result->note + length, sizeof(result->note) - length,
             " Its texture is a generated board.");
    return true;
}

bool demo_mesh_model(struct model *model, struct demo_result *result)
{
    struct model_source source;
    struct mesh mesh;
    if (!demo_mesh_load(&mesh, &source, result))
        return false;
    const bool done = model_make(model, &mesh) &&
                      model_add_texture(model, &mesh, &source) &&
                      demo_mesh_add_texture(model, result);
    mesh_free(&mesh);
    if (!done)
        model_free(model);
    return done;
}

static bool draw(struct scene *scene, struct canvas *canvas,
                 const struct scene_settings *settings,
                 struct demo_result *result)
{
    const double start = milliseconds();
    pel_clear(&canvas->surface, settings->camera.background);
    const bool done =
        scene_prepare(scene, settings) && scene_draw(scene, &canvas->surface);
    result->milliseconds = milliseconds() - start;
    return done && canvas_picture(canvas, &result->picture);
}

bool demo_mesh_draw(const struct model *model,
                    const struct scene_settings *settings,
                    struct demo_result *result)
{
    const struct camera *camera = &settings->camera;
    struct canvas canvas;
    struct scene scene;
    if (!canvas_init(&canvas, &pel_xrgb8888, camera->width, camera->height))
        return false;
    const bool done =
        scene_init(&scene, model) && draw(&scene, &canvas, settings, result);
    scene_free(&scene);
    canvas_free(&canvas);
    return done;
}
