/* A mesh in 3-D with all that a picture may need: cut by the near plane, lit
 * flat, at the vertices and at every pixel, with a texture, bilinear, affine
 * and in perspective; sorted. */
#include "scene.h"

static const uint16_t uv[4][2] = {
    {0, 0}, {65535, 0}, {0, 65535}, {32768, 32768}};
static const pel_color texels[4] = {PEL_RGB(255, 0, 0), PEL_RGB(0, 255, 0),
                                    PEL_RGB(0, 0, 255), PEL_RGB(9, 9, 9)};
static const struct pel_mesh mesh = SCENE_MESH(uv);

int main(void)
{
    static struct pel_mesh_texture texture = {
        .texels = {.colors = texels, .width = 2, .height = 2, .opaque = true},
        .mapping = &pel_map_affine,
        .sampler = pel_texture_init_bilinear,
        .span = 16};
    static struct pel_scene scene = SCENE(mesh, pel_shade_lit_flat);
    int status = scene_show(&scene);
    scene.shading = &pel_shade_phong;
    status |= scene_show(&scene);
    scene.texture = &texture;
    status |= scene_show(&scene);
    texture.mapping = &pel_map_perspective;
    scene.shading = &pel_shade_lit_gouraud;
    return status | scene_show(&scene);
}
