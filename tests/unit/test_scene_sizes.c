/* Sizes and distances beyond what the 3-D pipeline takes. */
#include "core/scene/pipeline.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"

TEST(depth_sizes)
{
    static const struct {
        struct pel_rect bounds;
        int bits;
        uint64_t size;
    } row[] = {
        {{0, 0, 32767, 32767}, 32, UINT64_C(4294705156)},
        {{-32768, 5, -32767, 6}, 16, 2},
        {{0, 0, 1, 1}, 8, 0},
        {{0, 0, 0, 1}, 16, 0},
        {{32767, 0, 32769, 1}, 16, 0},
        {{INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX}, 16, 0},
        {{INT32_MIN, 0, INT32_MIN + 1, 2}, 16, 0},
        {{0, -2147483647, 1, 2}, 32, 0},
    };
    static char least[PEL_DEPTH_SIZE(21, 3, 32)];
    assert_int_equal(pel_depth_size(&(struct pel_rect){-1, 5, 20, 8}, 32),
                     sizeof least);
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct pel_depth depth;
        uint32_t memory;
        assert_int_equal(pel_depth_size(&row[i].bounds, row[i].bits),
                         row[i].size <= SIZE_MAX ? row[i].size : 0);
        if (row[i].size == 0)
            assert_int_equal(
                pel_depth_init(&depth, &row[i].bounds, row[i].bits, &memory, 4),
                PEL_ERROR_SIZE);
        if (row[i].size == 0) /* a buffer without a pixel */
            pel_depth_clear(&depth);
    }
}

static int16_t positions[3][3];
static const int8_t normals[3][3] = {{127, 0, 0}, {0, 127, 0}, {0, 0, 127}};
static const uint8_t indices[1][3] = {{0, 1, 2}};
static const struct pel_camera camera = {
    .target = {0, 0, -1},
    .up = {0, 1, 0},
    .focal = 1,
    .sensor = {PEL_UNITS(10), PEL_UNITS(10)},
    .near_plane = PEL_LENGTH_MAX};

static struct pel_mesh triangle(int32_t step, int32_t shift)
{
    return (struct pel_mesh){.vertices = 3,
                             .triangles = 1,
                             .position = {{0, 0, 0}, step, shift},
                             .positions = (void *)positions,
                             .normals8 = normals,
                             .indices8 = indices};
}

static enum pel_status prepare(const struct pel_mesh *mesh,
                               enum pel_projection projection)
{
    static uint64_t scratch[PEL_SCENE_SCRATCH_SIZE(3, 1, 1) / 8 + 1];
    const struct pel_light light = {.color = {65536, 65536, 65536}};
    const struct pel_lighting lighting = {.light = &light,
                                          .lights = 1,
                                          .diffuse = PEL_FACTOR(50),
                                          .specular = PEL_FACTOR(50),
                                          .shininess = 8};
    struct pel_scene scene = {.mesh = mesh,
                              .camera = camera,
                              .viewport = {0, 0, 32767, 32767},
                              .shading = &pel_shade_lit_gouraud,
                              .lighting = &lighting};
    uint32_t pixels[16];
    const struct pel_surface s =
        surface_of(&pel_xrgb8888, pixels, sizeof pixels, 4, 4);
    struct pel_frame frame;
    scene.camera.projection = projection;
    const enum pel_status status =
        pel_scene_prepare(&frame, &scene, scratch, sizeof scratch);
    pel_scene_draw(&frame, &s);
    return status;
}

/* A vertex 16,384 units away is the last; one of a world's corners is lit and
 * projected by any quantization. */
TEST(a_mesh_ends_where_the_world_does)
{
    for (int32_t shift = PEL_MESH_SHIFT_MIN; shift <= 17; shift++)
        for (int32_t step = 1; step <= 16384; step *= 2) {
            struct pel_mesh mesh = triangle(step, shift);
            const int64_t last =
                shift < 0 ? 16384 >> -shift : INT64_C(16384) << shift;
            const int64_t q = last / step < 32767 ? last / step : 32767;
            const int axis = (shift + 14) % 3, sign = step % 3 == 1 ? 1 : -1;
            for (int k = 0; k < 3; k++)
                positions[k / 2][k] = (int16_t)(sign * q);
            mesh.position.offset[axis] =
                (int32_t)(sign * pel_min((int32_t)(last - q * step),
                                         INT32_C(1) << 30));
            assert_int_equal(pel_mesh_check(&mesh, NULL), PEL_OK);
            assert_int_equal(prepare(&mesh, PEL_PERSPECTIVE), PEL_OK);
            assert_int_equal(prepare(&mesh, PEL_ORTHOGRAPHIC), PEL_OK);
            mesh.position.offset[axis] += sign;
            if (shift < 17)
                assert_int_equal(prepare(&mesh, PEL_PERSPECTIVE),
                                 PEL_ERROR_SIZE);
        }
}

/* It was lit by a square root beyond the end of a table. */
TEST(a_mesh_beyond_the_world)
{
    struct pel_mesh mesh = triangle(16384, -6);
    mesh.position.offset[0] = mesh.position.offset[1] = 83791;
    for (int k = 0; k < 3; k++)
        positions[k][k] = 30000;
    assert_int_equal(prepare(&mesh, PEL_PERSPECTIVE), PEL_ERROR_SIZE);
    assert_int_equal(pel_mesh_check(&mesh, NULL), PEL_ERROR_SIZE);
}

TEST(projectors_of_nothing)
{
    static const struct pel_rect view = {0, 0, 128, 128};
    const struct pel_mesh mesh = triangle(1, 6);
    struct pel_projector p;
    assert_int_equal(pel_projector_init(&p, &mesh, NULL, &camera, &view),
                     PEL_ERROR_NULL);
    assert_int_equal(
        pel_projector_init(&p, NULL, &pel_pose_none, &camera, &view),
        PEL_ERROR_NULL);
}
