/* A vase of 220 triangles, lit and textured, on a panel of 240 x 320 pixels, in
 * 8 KB of RAM with the stack: a line at a time. */
#include "ppm.h"
#include "vase_small.h"

enum { WIDTH = 240, HEIGHT = 320, LINES = 1, VERTICES = 143, TRIANGLES = 220 };

static uint16_t band[WIDTH * LINES];
static uint64_t scratch[PEL_SCENE_SCRATCH_SIZE(VERTICES, TRIANGLES, 1) / 8];

/* Stripes of glaze, as `pel import` would make them of a picture. */
static const pel_color glaze[8] = {
    PEL_RGB(240, 232, 210), PEL_RGB(60, 100, 180), PEL_RGB(240, 232, 210),
    PEL_RGB(200, 120, 70),  PEL_RGB(60, 100, 180), PEL_RGB(240, 232, 210),
    PEL_RGB(200, 120, 70),  PEL_RGB(240, 232, 210)};
static const struct pel_mesh_texture texture = {
    .texels = {.colors = glaze, .width = 4, .height = 2, .opaque = true},
    .mapping = &pel_map_affine,
    .sampler = pel_texture_init_nearest,
    .wrap_u = PEL_WRAP_REPEAT,
    .wrap_v = PEL_WRAP_REPEAT};

static const struct pel_light sun = {
    .at = {1, 2, 2}, .directional = true, .color = {65536, 65536, 65536}};
static const struct pel_lighting lighting = {
    .light = &sun,
    .lights = 1,
    .ambient_color = {65536, 65536, 65536},
    .ambient = PEL_FACTOR(30),
    .diffuse = PEL_FACTOR(70),
    .shininess = 1};

int main(void)
{
    struct pel_mesh mesh;
    const struct pel_scene scene = {
        .mesh = &mesh,
        .camera = {.eye = {PEL_UNITS(1), PEL_UNITS(2.4), PEL_UNITS(4)},
                   .target = {0, PEL_UNITS(0.9), 0},
                   .up = {0, 1, 0},
                   .focal = 50,
                   .sensor = {24, 32},
                   .near_plane = PEL_UNITS(1) / 16},
        .viewport = {0, 0, WIDTH, HEIGHT},
        .shading = &pel_shade_lit_gouraud,
        .lighting = &lighting,
        .texture = &texture,
        .cull = PEL_CULL_NONE,
        .sort = &pel_depth_sort};
    struct pel_frame frame;
    pel_mesh_of_asset(&mesh, &vase_small);
    if (pel_mesh_asset_check(&vase_small) != PEL_OK ||
        pel_scene_prepare(&frame, &scene, scratch, sizeof scratch) != PEL_OK)
        return 1;
    printf("P6 %d %d 255\n", WIDTH, HEIGHT);
    for (int y = 0; y < HEIGHT; y += LINES) {
        const struct pel_rect lines = {0, y, WIDTH, y + LINES};
        struct pel_surface screen;
        if (pel_surface_init(&screen, &pel_rgb565_be, band, sizeof band,
                             &lines) != PEL_OK)
            return 1;
        pel_clear(&screen, PEL_RGB(32, 36, 48));
        pel_scene_draw(&frame, &screen);
        ppm_write(&screen);
    }
    return 0;
}
