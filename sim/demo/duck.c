/* The demo `duck`: a mesh painted back to front, flat and Gouraud, with the
 * colours that its texture has at the vertices. */
#include "sim/demo/mesh.h"

enum { SIZE = 1200 };

static bool draw(struct demo_result *result, int shade)
{
    struct model_source source;
    struct model model;
    struct mesh mesh;
    struct scene_settings settings = scene_default;
    settings.camera.width = settings.camera.height = SIZE;
    settings.shade = (enum scene_shade)shade;
    settings.texture = SCENE_TEXTURE_NEAREST;
    settings.mapping = SCENE_MAP_VERTICES;
    if (!demo_mesh_load(&mesh, &source, result))
        return false;
    const bool done = model_make(&model, &mesh) &&
                      model_add_texture(&model, &mesh, &source) &&
                      demo_mesh_draw(&model, &settings, result);
    model_free(&model);
    mesh_free(&mesh);
    return done;
}

const struct demo demo_duck[] = {
    {"duck-flat",
     "A mesh painted back to front, one colour per triangle: the mean of its "
     "three vertices.",
     draw, SCENE_FLAT},
    {"duck-gouraud",
     "The same triangles with the colours of their vertices interpolated.",
     draw, SCENE_GOURAUD},
    {NULL, NULL, NULL, 0},
};
