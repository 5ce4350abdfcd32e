/* Where 3-D pipelines fail, and what happens here. */
#include <stdlib.h>
#include <string.h>

#include "core/scene/pipeline.h"
#include "core/scene/select.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"
#include "tests/support/reference_scene.h"

enum { SIDE = 128 };

static const struct pel_rect view = {0, 0, SIDE, SIDE};

/* Two triangles, at `height` below the eye, 2 `half` wide and long. */
struct ground {
    struct pel_scene scene;
    struct pel_mesh mesh;
    int16_t positions[4][3];
    uint64_t scratch[PEL_SCENE_SCRATCH_SIZE(4, 2, 1) / 8 + 1];
};

static const uint8_t quad[2][3] = {{0, 1, 2}, {0, 2, 3}};
static const uint16_t quad_uv[4][2] = {
    {0, 65535}, {65535, 65535}, {65535, 0}, {0, 0}};

static struct ground g;
static pel_color pixels[SIDE * SIDE];

static void ground_init(int16_t half, int16_t height)
{
    for (int i = 0; i < 4; i++) {
        g.positions[i][0] = (int16_t)(i % 3 ? half : -half);
        g.positions[i][1] = (int16_t)-height;
        g.positions[i][2] = (int16_t)(i < 2 ? half : -half);
    }
    g.mesh = (struct pel_mesh){.vertices = 4,
                               .triangles = 2,
                               .position = {{0, 0, 0}, 1, 6},
                               .texture = {{0, 0, 0}, 1, 16},
                               .positions = (void *)g.positions,
                               .uv = quad_uv,
                               .indices8 = quad};
    g.scene = (struct pel_scene){.mesh = &g.mesh,
                                 .camera = {.target = {0, 0, -PEL_UNITS(1)},
                                            .up = {0, 1, 0},
                                            .focal = 50,
                                            .sensor = {100, 100},
                                            .near_plane = PEL_UNITS(1) / 64},
                                 .viewport = view,
                                 .shading = &pel_shade_flat,
                                 .color = PEL_RGB(255, 255, 255),
                                 .sort = &pel_depth_sort,
                                 .cull = PEL_CULL_BACK};
}

static enum pel_status prepare(struct pel_frame *frame)
{
    return pel_scene_prepare(frame, &g.scene, g.scratch, sizeof g.scratch);
}

static struct pel_surface clear(void)
{
    memset(pixels, 0, sizeof pixels);
    return surface_of(&pel_xrgb8888, pixels, sizeof pixels, SIDE, SIDE);
}

static void draw(void)
{
    const struct pel_surface s = clear();
    struct pel_frame frame;
    assert_int_equal(prepare(&frame), PEL_OK);
    pel_scene_draw(&frame, &s);
}

/* Where the ray through a pixel meets the ground: x and -z in units. */
static bool meets_ground(real half, real height, int32_t x, int32_t y,
                         real at[2])
{
    const real scale = (real)SIDE * 50 / 100;
    const real down = (y + 0.5L - SIDE / 2) / scale;
    const real right = (x + 0.5L - SIDE / 2) / scale;
    if (down <= 0)
        return false;
    at[1] = height / down;
    at[0] = right * at[1];
    return at[1] >= 1.0L / 64 && at[1] < half && at[0] >= -half && at[0] < half;
}

/* The ground goes on behind the eye, and out of range to the sides. */
TEST(near_plane)
{
    for (int32_t half = 64; half < 32000; half = half * 3 / 2) {
        int32_t wrong = 0;
        real at[2];
        ground_init((int16_t)half, 32);
        draw();
        for (int32_t y = 0; y < SIDE; y++)
            for (int32_t x = 0; x < SIDE; x++)
                wrong += meets_ground((real)half / 64, 0.5L, x, y, at) !=
                         (pixels[y * SIDE + x] != 0);
        if (wrong * 1000 > SIDE * SIDE)
            fail_msg("%d wide: %d pixels differ", half, wrong);
    }
}

/* The same with a texture: no place of it moves by the cuts. */
TEST(texture_across_the_near_plane)
{
    enum { TEXELS = 256 };
    static pel_color texels[TEXELS * TEXELS];
    const struct pel_mesh_texture texture = {
        .texels = {NULL, texels, TEXELS, TEXELS, true},
        .mapping = &pel_map_perspective,
        .sampler = pel_texture_init_nearest};
    real worst = 0, at[2];
    for (int32_t i = 0; i < TEXELS * TEXELS; i++)
        texels[i] = UINT32_C(0xFF000000) | (uint32_t)i;
    for (int32_t half = 64; half < 32000; half = half * 3 / 2) {
        const real size = (real)half / 64;
        ground_init((int16_t)half, 32);
        g.scene.texture = &texture;
        draw();
        for (int32_t y = SIDE / 2 + 8; y < SIDE; y++)
            for (int32_t x = 0; x < SIDE; x++) {
                const uint32_t got = pixels[y * SIDE + x] & 0xFFFFFFu;
                if (!got || !meets_ground(size, 0.5L, x, y, at))
                    continue;
                const real u = (at[0] + size) / (2 * size) * TEXELS;
                const real v = (size - at[1]) / (2 * size) * TEXELS;
                const real left = got % TEXELS, top = (real)(got / TEXELS);
                const real off[4] = {u - left - 1, left - u, v - top - 1,
                                     top - v};
                for (int k = 0; k < 4; k++)
                    worst = off[k] > worst ? off[k] : worst;
            }
    }
    assert_true(worst < 1.0L / 64);
}

/* A wall around the eye fills the picture, however far its corners are. */
TEST(guard_band)
{
    for (int16_t away = 1; away < 1000; away = (int16_t)(away * 2)) {
        ground_init(32767, away);
        for (int i = 0; i < 4; i++) { /* upright, before the eye */
            g.positions[i][1] = (int16_t)-g.positions[i][2];
            g.positions[i][2] = (int16_t)-away;
        }
        draw();
        for (int32_t i = 0; i < SIDE * SIDE; i++)
            if (pixels[i] != UINT32_C(0xFFFFFFFF))
                fail_msg("away %d: pixel %d, %d", away, i % SIDE, i / SIDE);
    }
}

TEST(behind_is_nothing)
{
    ground_init(1000, 10);
    g.scene.camera.near_plane = PEL_UNITS(100);
    draw();
    for (int32_t i = 0; i < SIDE * SIDE; i++)
        assert_int_equal(pixels[i], 0);
}

/* Opposite normals meet in one that has no direction: ambient light there, and
 * no color beyond those of either side. */
TEST(opposite_normals)
{
    static const int8_t normals[4][3] = {
        {0, 127, 0}, {0, -127, 0}, {0, -127, 0}, {0, 127, 0}};
    const struct pel_light sun = {{0, 1, 0}, true, {65536, 65536, 65536}};
    const struct pel_lighting lighting = {
        .light = &sun,
        .lights = 1,
        .ambient_color = {65536, 65536, 65536},
        .ambient = PEL_FACTOR(25),
        .diffuse = PEL_FACTOR(50),
        .shininess = 1};
    uint32_t bright = 0, dark = 0;
    ground_init(300, 100);
    g.mesh.normals8 = normals;
    g.scene.lighting = &lighting;
    g.scene.shading = &pel_shade_phong;
    draw();
    for (int32_t i = 0; i < SIDE * SIDE; i++) {
        const uint32_t v = pixels[i] & 255;
        bright += v == 191;
        dark += v == 64;
        if (v != 191 && v != 64 && v != 0)
            fail_msg("pixel %d, %d: %u", i % SIDE, i / SIDE, v);
    }
    assert_true(bright > 100 && dark > 100);
}

/* Needles, seen from a side that makes them a few sub-pixels thick or less:
 * colors stay between those of their vertices. */
TEST(slivers)
{
    static const uint8_t colors[4][3] = {
        {10, 20, 30}, {240, 20, 130}, {10, 250, 30}, {10, 250, 230}};
    int32_t seen = 0;
    for (int16_t thick = -40; thick <= 40; thick++) {
        ground_init(30000, 1);
        g.mesh.colors = colors;
        g.mesh.position.shift = 14;
        g.scene.cull = PEL_CULL_NONE;
        g.scene.shading = &pel_shade_gouraud;
        for (int i = 0; i < 4; i++) {
            g.positions[i][0] = (int16_t)(i * 15000 - 22000);
            g.positions[i][1] = (int16_t)(i * 9000 - 13000 + i % 2 * thick);
            g.positions[i][2] = -32000;
        }
        draw();
        for (int32_t i = 0; i < SIDE * SIDE; i++) {
            const pel_color v = pixels[i];
            seen += v != 0;
            if (v &&
                (pel_red(v) < 10 || pel_red(v) > 240 || pel_green(v) < 20 ||
                 pel_green(v) > 250 || pel_blue(v) < 30 || pel_blue(v) > 230))
                fail_msg("thick %d: pixel %d, %d is %06x", thick, i % SIDE,
                         i / SIDE, v & 0xFFFFFF);
        }
    }
    assert_true(seen > 100);
}

TEST(a_wrong_index_is_named)
{
    static uint16_t indices16[2][3] = {{0, 1, 2}, {0, 4, 3}};
    static uint32_t indices32[2][3] = {{0, 1, 2}, {0, 2, UINT32_MAX}};
    struct pel_frame frame;
    ground_init(1000, 10);
    g.mesh.indices8 = NULL;
    for (int i = 0; i < 2; i++) {
        g.mesh.indices16 = i ? NULL : (void *)indices16;
        g.mesh.indices32 = i ? (void *)indices32 : NULL;
        assert_int_equal(prepare(&frame), PEL_ERROR_RANGE);
        assert_int_equal(frame.fault.triangle, 1);
        assert_int_equal(frame.fault.index, i ? UINT32_MAX : 4);
    }
    g.mesh.indices8 = quad; /* two arrays */
    assert_int_equal(pel_mesh_check(&g.mesh, NULL), PEL_ERROR_NULL);
}

TEST(a_frame_that_failed_draws_nothing)
{
    static uint32_t values[SIDE * SIDE];
    struct pel_depth depth;
    struct pel_frame frame;
    ground_init(1000, 10);
    pel_depth_init(&depth, &view, 32, values, sizeof values);
    for (int failed = 0; failed < 2; failed++) {
        const struct pel_surface s = clear();
        assert_int_equal(prepare(&frame), PEL_OK);
        if (failed)
            assert_int_equal(pel_scene_prepare(&frame, NULL, NULL, 0),
                             PEL_ERROR_NULL);
        pel_scene_draw(&frame, &s);
        pel_scene_draw_depth(&frame, &s, &depth);
        assert_int_equal(pixels[SIDE * (SIDE - 1)] == 0, failed);
    }
}

/* With exactly the memory that it takes, and refused with less. */
static enum pel_status prepare_least(void)
{
    const struct pel_scene *scene = &g.scene;
    struct pel_frame frame;
    const size_t size = pel_scene_scratch_size(scene);
    static char least[PEL_SCENE_SCRATCH_SIZE(4, 2, 0)];
    assert_int_equal(size, sizeof least);
    assert_int_equal(pel_scene_prepare(&frame, scene, g.scratch, size - 1),
                     PEL_ERROR_SCRATCH);
    assert_int_equal(
        pel_scene_prepare(&frame, scene, (uint8_t *)g.scratch + 4, size),
        PEL_ERROR_SCRATCH);
    return pel_scene_prepare(&frame, scene, g.scratch, size);
}

/* Values in perspective take memory where a shading names them, and only
 * there. */
TEST(memory_of_perspective)
{
    const struct pel_shading *const in_world[] = {
        &pel_perspective_gouraud, &pel_perspective_lit_gouraud,
        &pel_perspective_phong, &pel_perspective_chosen};
    ground_init(1000, 10);
    const size_t least = pel_scene_scratch_size(&g.scene);
    for (int i = 0; i < 4; i++) {
        struct pel_frame frame;
        g.scene.shading = in_world[i];
        assert_int_equal(pel_scene_scratch_size(&g.scene),
                         least + PEL_PERSPECTIVE_SCRATCH_SIZE);
        assert_int_equal(pel_scene_prepare(&frame, &g.scene, g.scratch, least),
                         PEL_ERROR_SCRATCH);
    }
}

TEST(what_cannot_be_seen_is_refused)
{
    struct pel_camera *c = &g.scene.camera;
    const struct {
        int32_t *number, value;
        enum pel_status status;
    } rows[] = {{&c->target[2], 0, PEL_ERROR_RANGE}, /* where the eye is */
                {&c->eye[0], PEL_LENGTH_MAX + 1, PEL_ERROR_RANGE},
                {&c->near_plane, 0, PEL_ERROR_RANGE},
                {&c->sensor[1], 0, PEL_ERROR_SIZE},
                {&g.scene.viewport.x1, 0, PEL_ERROR_SIZE}};
    ground_init(1000, 10);
    assert_int_equal(prepare_least(), PEL_OK);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        ground_init(1000, 10);
        *rows[i].number = rows[i].value;
        assert_int_equal(prepare_least(), rows[i].status);
    }
    ground_init(1000, 10);
    c->target[2] = 0;
    c->target[1] = 5; /* along `up` */
    assert_int_equal(prepare_least(), PEL_ERROR_RANGE);
    ground_init(1000, 10);
    g.scene.shading = &pel_shade_phong; /* no normals, no light */
    assert_int_equal(prepare_least(), PEL_ERROR_NULL);
}

/* A plane of a million triangles, seen from above: no gap, and of those in
 * whose box no pixel centre lies none is listed. */
TEST(a_million_triangles)
{
    enum { CELLS = 708 };
    const uint32_t row = CELLS + 1;
    int16_t(*positions)[3] = malloc(sizeof *positions * row * row);
    uint32_t(*indices)[3] = malloc(sizeof *indices * 2 * CELLS * CELLS);
    struct pel_frame frame;
    ground_init(1, 1);
    for (uint32_t i = 0; i < row * row; i++) {
        positions[i][0] = (int16_t)((int32_t)(i % row) * 92 - 32568);
        positions[i][1] = 0;
        positions[i][2] = (int16_t)((int32_t)(i / row) * 92 - 32568);
    }
    for (uint32_t i = 0; i < CELLS * CELLS; i++) {
        const uint32_t at = i / CELLS * row + i % CELLS;
        const uint32_t two[2][3] = {{at, at + row, at + row + 1},
                                    {at, at + row + 1, at + 1}};
        memcpy(indices[2 * i], two, sizeof two);
    }
    g.mesh = (struct pel_mesh){.vertices = row * row,
                               .triangles = 2 * CELLS * CELLS,
                               .position = {{0, 0, 0}, 1, 12},
                               .positions = (void *)positions,
                               .indices32 = (void *)indices};
    g.scene.camera.eye[1] = PEL_UNITS(7);
    g.scene.camera.target[2] = 0;
    g.scene.camera.up[2] = -1;
    g.scene.camera.up[1] = 0;
    const size_t size = pel_scene_scratch_size(&g.scene);
    void *scratch = malloc(size);
    assert_int_equal(pel_scene_prepare(&frame, &g.scene, scratch, size),
                     PEL_OK);
    assert_in_range(frame.triangles, SIDE * SIDE, 2 * SIDE * SIDE);
    const struct pel_surface s = clear();
    pel_scene_draw(&frame, &s);
    for (int32_t i = 0; i < SIDE * SIDE; i++)
        assert_int_equal(pixels[i], 0xFFFFFFFF);
    free(scratch);
    free(positions);
    free(indices);
}
