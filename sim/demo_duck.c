/* The demo `duck`: a mesh painted back to front, flat and Gouraud, with the
 * colours that its texture has at the vertices. */
#include "demo_mesh.h"

enum { SIZE = 1200 };

static bool draw(struct demo_result *result, int shade)
{
    struct model_source source;
    struct model model;
    struct mesh mesh;
    struct stage_settings settings = stage_default;
    settings.camera.width = settings.camera.height = SIZE;
    settings.shade = (enum stage_shade)shade;
    settings.texture = STAGE_TEXTURE_NEAREST;
    settings.mapping = STAGE_MAP_VERTICES;
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
     draw, STAGE_FLAT},
    {"duck-gouraud",
     "The same triangles with the colours of their vertices interpolated.",
     draw, STAGE_GOURAUD},
    {NULL, NULL, NULL, 0},
};
