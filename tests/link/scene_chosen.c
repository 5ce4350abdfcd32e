/* A mesh in 3-D lit to a tolerance of two steps. */
#include "core/scene/select.h"
#include "scene.h"

static const struct pel_mesh mesh = SCENE_MESH(NULL);

int main(void)
{
    struct pel_scene scene = SCENE(mesh, pel_shade_chosen);
    scene.tolerance = 2 * 256;
    return scene_show(&scene);
}
