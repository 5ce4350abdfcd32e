/* Sizes and distances beyond what the 3-D pipeline takes. */
#include "core/scene/pipeline.h"
#include "tests/support/check.h"

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

/* What pel_mesh_check takes may lie farther away than that. */
TEST(an_orthographic_mesh_far_away)
{
    static const int16_t positions[1][3] = {{0, 0, 0}};
    static const uint8_t indices[1][3] = {{0, 0, 0}};
    static const struct pel_rect view = {0, 0, 128, 128};
    static const struct pel_camera camera = {
        .target = {0, 0, -1},
        .up = {0, 1, 0},
        .sensor = {PEL_UNITS(1000), PEL_UNITS(1000)},
        .near_plane = PEL_LENGTH_MAX,
        .projection = PEL_ORTHOGRAPHIC};
    struct pel_mesh mesh = {.vertices = 1,
                            .triangles = 1,
                            .position = {{0, 0, 0}, 1, 6},
                            .positions = positions,
                            .indices8 = indices};
    struct pel_projector p;
    assert_int_equal(
        pel_projector_init(&p, &mesh, &pel_pose_none, &camera, &view), PEL_OK);
    mesh.position.step = 16384;
    for (int32_t shift = 46; shift >= -14; shift--) {
        mesh.position.shift = shift;
        assert_int_equal(pel_mesh_check(&mesh, NULL), PEL_OK);
        assert_int_equal(
            pel_projector_init(&p, &mesh, &pel_pose_none, &camera, &view),
            shift > 1 ? PEL_OK : PEL_ERROR_RANGE);
    }
    assert_int_equal(pel_projector_init(&p, &mesh, NULL, &camera, &view),
                     PEL_ERROR_NULL);
    assert_int_equal(
        pel_projector_init(&p, NULL, &pel_pose_none, &camera, &view),
        PEL_ERROR_NULL);
}
