/* A mesh in 3-D with light at its vertices, sorted, and nothing else. */
#include "scene.h"

static const struct pel_mesh mesh = SCENE_MESH(NULL);

int main(void)
{
    static const struct pel_scene scene = SCENE(mesh, pel_shade_lit_gouraud);
    return scene_show(&scene);
}
