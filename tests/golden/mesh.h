/* The golden scenes with a mesh, and how it is seen and lit. */
#ifndef TESTS_GOLDEN_MESH_H
#define TESTS_GOLDEN_MESH_H

#include "tests/golden/size.h"

/* A ring of triangles, and a square that comes from far away, through it and
 * past the eye. */
enum { AROUND = 18, ACROSS = 10, RING = AROUND * ACROSS, VERTICES = RING + 4 };

static int16_t positions[VERTICES][3], normals[VERTICES][3];
static uint16_t uv[VERTICES][2];
static uint8_t colors[VERTICES][3], indices[2 * RING + 2][3];
static uint64_t frame_scratch[2048];
static uint16_t depths[WIDTH * LINES];

static void make_ring_vertex(int32_t i, int32_t around, int32_t across)
{
    const struct pel_point a =
        pel_direction((uint16_t)(around * 65536 / AROUND));
    const struct pel_point b =
        pel_direction((uint16_t)(across * 65536 / ACROSS));
    const int32_t reach = 20000 + b.x * 9000 / PEL_DIRECTION_ONE;
    positions[i][0] = (int16_t)(a.x * reach / PEL_DIRECTION_ONE);
    positions[i][1] = (int16_t)(a.y * reach / PEL_DIRECTION_ONE);
    positions[i][2] = (int16_t)(b.y * 9000 / PEL_DIRECTION_ONE);
    uv[i][0] = (uint16_t)(around * 700);
    uv[i][1] = (uint16_t)(across * 300);
    colors[i][0] = (uint8_t)(255 - 12 * around);
    colors[i][1] = (uint8_t)(25 * across);
    colors[i][2] = (uint8_t)(around % 3 * 100);
}

static void make_quad(uint8_t (*to)[3], int32_t a, int32_t b, int32_t c,
                      int32_t d)
{
    const int32_t corner[6] = {a, b, c, a, c, d};
    for (int i = 0; i < 6; i++)
        to[i / 3][i % 3] = (uint8_t)corner[i];
}

static void make_square(void)
{
    static const int16_t corner[4][3] = {{-9000, -2000, -32000},
                                         {9000, -2500, -32000},
                                         {12000, 3000, 32767},
                                         {-12000, 2500, 32767}};
    for (int i = 0; i < 4; i++) {
        memcpy(positions[RING + i], corner[i], sizeof corner[i]);
        uv[RING + i][0] = i % 3 ? 8000 : 0;
        uv[RING + i][1] = i < 2 ? 0 : 20000;
        colors[RING + i][i % 3] = 255;
    }
    make_quad(&indices[2 * RING], RING, RING + 1, RING + 2, RING + 3);
}

static int make_mesh(struct pel_mesh *mesh)
{
    *mesh = (struct pel_mesh){
        .vertices = VERTICES,
        .triangles = 2 * RING + 2,
        .position = {{0, 0, 0}, 3, 15},
        .texture = {{-4000, 100, 0}, 1, 12},
        .positions = (const int16_t(*)[3])positions,
        .uv = (const uint16_t(*)[2])uv,
        .colors = (const uint8_t(*)[3])colors,
        .indices8 = (const uint8_t(*)[3])indices,
    };
    for (int32_t i = 0; i < RING; i++) {
        const int32_t a = i / ACROSS, b = i % ACROSS;
        const int32_t next = (a + 1) % AROUND * ACROSS;
        const int32_t right = (b + 1) % ACROSS;
        make_ring_vertex(i, a, b);
        make_quad(&indices[2 * i], i, next + b, next + right,
                  a * ACROSS + right);
    }
    make_square();
    mesh->normals16 = (const int16_t(*)[3])normals;
    return pel_mesh_normals(mesh, normals, frame_scratch, sizeof frame_scratch);
}

static const struct pel_light lights[] = {
    {{PEL_UNITS(2), PEL_UNITS(3), PEL_UNITS(5)}, false, {65000, 60000, 50000}},
    {{-4, 3, 2}, true, {30000, 40000, 65536}}};

static const struct pel_lighting lighting = {
    .light = lights,
    .lights = 2,
    .ambient_color = {65536, 65536, 65536},
    .ambient = PEL_FACTOR(20),
    .diffuse = PEL_FACTOR(150),
    .specular = PEL_FACTOR(70),
    .shininess = 12};

/* Seen through its own turn, which is no simple one. */
static void set_view(struct pel_scene *scene, struct pel_mesh *mesh,
                     struct pel_pose *pose)
{
    struct pel_matrix a, b;
    pel_matrix_turn(&a, 0, 60000);
    pel_matrix_turn(&b, 1, 3333);
    pel_matrix_multiply(&pose->turn, &a, &b);
    pose->at[0] = PEL_UNITS(1) / 8;
    pose->at[1] = pose->at[2] = 0;
    *scene =
        (struct pel_scene){.mesh = mesh,
                           .pose = pose,
                           .camera = {.eye = {0, PEL_UNITS(1), PEL_UNITS(6)},
                                      .up = {0, 1, 0},
                                      .focal = 26,
                                      .sensor = {32, 24},
                                      .near_plane = PEL_UNITS(4)},
                           .viewport = {0, 0, WIDTH, HEIGHT},
                           .lighting = &lighting};
}

static void draw_scene(const struct pel_scene *scene,
                       const struct pel_surface *s,
                       const struct pel_depth *depth)
{
    struct pel_frame frame;
    if (pel_scene_prepare(&frame, scene, frame_scratch, sizeof frame_scratch) !=
        PEL_OK)
        printf("scene: refused\n");
    else if (depth)
        pel_scene_draw_depth(&frame, s, depth);
    else
        pel_scene_draw(&frame, s);
}

/* The painter: Phong under a bilinear texture in perspective, transparent. */
static void draw_phong(const struct pel_surface *s)
{
    static pel_color texels[8 * 5];
    const struct pel_mesh_texture texture = {
        .texels = {.colors = texels, .width = 8, .height = 5, .opaque = true},
        .mapping = &pel_map_perspective,
        .sampler = pel_texture_init_bilinear,
        .wrap_u = PEL_WRAP_REPEAT,
        .wrap_v = PEL_WRAP_MIRROR};
    struct pel_mesh mesh;
    struct pel_pose pose;
    struct pel_scene scene;
    for (int i = 0; i < 40; i++)
        texels[i] = PEL_RGB(255 - i * 3, 255 - i * i % 128, i % 7 * 40);
    if (make_mesh(&mesh) != PEL_OK)
        printf("mesh: refused\n");
    set_view(&scene, &mesh, &pose);
    scene.shading = &pel_shade_phong;
    scene.texture = &texture;
    scene.sort = &pel_depth_sort;
    scene.transparency = 70;
    draw_scene(&scene, s, NULL);
}

/* Depth buffers: Gouraud with light at the vertices, 16 bits. */
static void draw_depth(const struct pel_surface *s)
{
    struct pel_mesh mesh;
    struct pel_pose pose;
    struct pel_scene scene;
    struct pel_depth depth;
    if (make_mesh(&mesh) != PEL_OK ||
        pel_depth_init(&depth, &s->bounds, 16, depths, sizeof depths) != PEL_OK)
        printf("mesh or depth: refused\n");
    set_view(&scene, &mesh, &pose);
    scene.shading = &pel_shade_lit_gouraud;
    draw_scene(&scene, s, &depth);
}

#endif
