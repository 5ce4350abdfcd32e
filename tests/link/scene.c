/* A mesh in 3-D, cut by the near plane and sorted, with light flat, at the
 * vertices and at every pixel, and with a bilinear texture. */
#include "scene.h"

static const struct pel_mesh mesh = SCENE_MESH(scene_uv);

int main(void)
{
    static const struct pel_mesh_texture texture =
        SCENE_TEXTURE(pel_map_affine);
    static struct pel_scene scene = SCENE(mesh, pel_shade_lit_flat);
    int status = scene_show(&scene);
    scene.shading = &pel_shade_phong;
    status |= scene_show(&scene);
    scene.texture = &texture;
    status |= scene_show(&scene);
    scene.shading = &pel_shade_lit_gouraud;
    return status | scene_show(&scene);
}
