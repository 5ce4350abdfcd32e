/* The lines of docs/use.md that give a scene the pictures of a mesh: those of
 * `duck` are of a pixel each, and seen in this order. */
#include <stdio.h>

#include <pel/pel.h>

#define IMAGE(pixel)                                                          \
    {                                                                         \
        PEL_IMAGE_MAGIC, PEL_IMAGE_VERSION, PEL_FORMAT_RGB565_LE, 1, 1, 2, 2, \
            pixel                                                             \
    }

int main(void)
{
    static const uint8_t red[2] = {0x00, 0xF8}, blue[2] = {0x1F, 0x00};
    static const struct pel_image_asset pixels[2] = {IMAGE(red), IMAGE(blue)};
    static const struct pel_mesh_image images[2] = {
        {&pixels[0], PEL_WRAP_CLAMP, PEL_WRAP_CLAMP, false},
        {&pixels[1], PEL_WRAP_REPEAT, PEL_WRAP_CLAMP, false}};
    static const pel_color expected[2] = {PEL_RGB(255, 0, 0),
                                          PEL_RGB(0, 0, 255)};
    static const struct pel_mesh_asset duck = {.image = images, .images = 2};
    struct pel_scene scene = {.textures = 0};
#include "textures.inc"
    for (uint32_t i = 0; i < scene.textures; i++) {
        const struct pel_surface *const s = scene.texture[i].texels.surface;
        pel_color color;
        s->format->load(s, 0, 0, 1, &color);
        if (color != expected[i] || scene.texture[i].wrap_u != images[i].wrap_u)
            return 1;
    }
    return scene.textures != 2;
}
