/* The demo `duck`: a mesh painted back to front, flat and Gouraud. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "canvas.h"
#include "core/format/formats.h"
#include "core/raster/rectangle.h"
#include "demo.h"
#include "mesh_input.h"
#include "render_painter.h"

/* Where Debian's package assimp-testmodels has its models; the variable
 * PEL_MODELS names another directory. */
#define MODELS "/usr/share/assimp/models"
#define DUCK "Collada/duck.dae"

enum { SIZE = 1200 };

/* The duck if this build can read it and it is there, else the built-in mesh.
 * `path` gets what was taken, `note` says so. */
static void find_mesh(char *path, size_t path_size, char *note,
                      size_t note_size)
{
    const char *models = getenv("PEL_MODELS");
    snprintf(path, path_size, "%s/%s", models ? models : MODELS, DUCK);
    bool is_there = access(path, R_OK) == 0;
    if (is_there && mesh_files_supported()) {
        snprintf(note, note_size, "The mesh is %s of assimp-testmodels.", DUCK);
        return;
    }
    snprintf(path, path_size, "%s", MESH_BUILTIN);
    snprintf(note, note_size,
             "The built-in vase stands in for the duck: %s is missing.",
             is_there ? "libassimp-dev (at build time)"
                      : "the package assimp-testmodels");
}

static bool paint(const struct pel2d *flat, enum painter_shade shade,
                  struct demo_result *result)
{
    struct canvas canvas;
    struct painter painter = {.shade = shade};
    if (!canvas_init(&canvas, &pel_xrgb8888, SIZE, SIZE))
        return false;
    double start = demo_clock();
    pel_clear(&canvas.surface, PEL_RGB(255, 255, 255));
    bool done = painter_init(&painter, flat);
    if (done)
        painter_draw(&canvas.surface, &painter);
    result->milliseconds = demo_clock() - start;
    done = done && canvas_picture(&canvas, &result->picture);
    painter_free(&painter);
    canvas_free(&canvas);
    return done;
}

static bool draw(enum painter_shade shade, struct demo_result *result)
{
    char path[4096];
    struct pel2d flat;
    struct mesh_input input = {.path = path, .camera = camera_default};
    find_mesh(path, sizeof(path), result->note, sizeof(result->note));
    input.camera.width = input.camera.height = SIZE;
    if (!mesh_input_load(&input, &flat))
        return false;
    bool done = paint(&flat, shade, result);
    pel2d_free(&flat);
    return done;
}

static bool draw_flat(struct demo_result *result)
{
    return draw(PAINTER_FLAT, result);
}

static bool draw_gouraud(struct demo_result *result)
{
    return draw(PAINTER_GOURAUD, result);
}

const struct demo demo_duck[] = {
    {"duck-flat",
     "A mesh painted back to front, one colour per triangle: the mean of its "
     "three vertices.",
     draw_flat},
    {"duck-gouraud",
     "The same triangles with the colours of their vertices interpolated.",
     draw_gouraud},
    {NULL, NULL, NULL},
};
