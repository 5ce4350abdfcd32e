/* Depths of 16 bits where pel_scene_depth_bits allows them: of two triangles
 * that face the eye the nearer one wins in any order, with a quarter of the gap
 * it often does not; two tilted ones look as with 32 bits. */
#include "core/scene/select.h"
#include "tests/support/any_scene.h"
#include "tests/support/check.h"

enum { SIDE = 16, UNIT = 64 };

static int16_t positions[6][3];
static const uint8_t indices[2][3] = {{0, 1, 2}, {3, 4, 5}};
static uint64_t scratch[400];
static const struct pel_mesh mesh = {.vertices = 6,
                                     .triangles = 2,
                                     .position = {{0, 0, 0}, 1, 6},
                                     .positions = (void *)positions,
                                     .indices8 = indices};

static struct pel_scene any_view(struct random *r)
{
    struct pel_scene scene = {.mesh = &mesh,
                              .camera = {.target = {0, 0, -PEL_UNITS(1)},
                                         .up = {0, 1, 0},
                                         .focal = 1000,
                                         .sensor = {900, 900}},
                              .viewport = {0, 0, SIDE, SIDE},
                              .shading = &any_scene_numbers};
    scene.camera.near_plane = random_between(r, 1024, PEL_UNITS(1));
    if (random_word(r) % 4 == 0) {
        scene.camera.projection = PEL_ORTHOGRAPHIC;
        scene.camera.sensor[0] = scene.camera.sensor[1] = PEL_UNITS(4);
    }
    return scene;
}

/* Two planes with the gap between, in any order. */
static void place(int32_t z, int32_t gap, bool swapped)
{
    static const int16_t corner[3][2] = {{-1, -1}, {1, -1}, {0, 1}};
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 2; k++)
            positions[i][k] = (int16_t)(corner[i % 3][k] * z / 3);
        positions[i][2] = (int16_t)((i < 3) == swapped ? -z : -z - gap);
    }
}

static void draw(const struct pel_frame *prepared, int bits,
                 struct canvas *canvas)
{
    static uint32_t depths[SIDE * SIDE];
    struct pel_frame frame = *prepared;
    const struct pel_rect *v = &frame.scene->viewport;
    struct pel_depth depth;
    pel_depth_init(&depth, v, bits, depths, sizeof depths);
    canvas_open(canvas, &pel_xrgb8888, v, 0);
    pel_scene_draw_depth(&frame, &canvas->surface, &depth);
}

/* Is the nearer one seen where it is? The middle of the picture is. */
static bool is_right(const struct pel_frame *frame, int bits, bool swapped)
{
    static struct canvas canvas;
    draw(frame, bits, &canvas);
    return (canvas_pixel(&canvas, SIDE / 2, SIDE / 2) & 255) ==
           (swapped ? 1 : 2);
}

static int prepare(const struct pel_scene *scene, struct pel_frame *frame,
                   int32_t gap)
{
    cases_forget();
    any_scene_keep(scene);
    assert_int_equal(pel_scene_prepare(frame, scene, scratch, sizeof scratch),
                     PEL_OK);
    return pel_scene_depth_bits(frame, gap * (PEL_UNITS(1) / UNIT));
}

TEST(the_nearer_one_wins)
{
    uint32_t allowed = 0, wrong = 0;
    for (struct cases c = cases_of(5000); cases_next(&c);) {
        const struct pel_scene scene = any_view(&c.random);
        const int32_t z = random_between(&c.random, 2 * UNIT, 200 * UNIT);
        const bool swapped = random_word(&c.random) % 2;
        struct pel_frame frame;
        int bits = 32;
        for (int32_t gap = 1; bits == 32 && gap < 300 * UNIT; gap *= 2) {
            place(z, gap, swapped);
            bits = prepare(&scene, &frame, gap);
            if (!is_right(&frame, bits, swapped))
                fail_msg("%d bits, %d behind %d; %s", bits, gap, z,
                         cases_replay());
            if (bits == 32 || gap < 4)
                continue;
            allowed++;
            place(z, gap / 4, swapped);
            prepare(&scene, &frame, gap);
            wrong += !is_right(&frame, 16, swapped);
        }
    }
    assert_true(cases_alone() || (allowed > 0 && wrong > 0));
}

/* Corners of a tilted triangle at distances of least to 3/2 least; the last one
 * of a sliver is in the middle of the others, or almost. */
static void any_corners(struct random *r, int32_t corner[3][3], int32_t least,
                        bool sliver)
{
    for (int i = 0; i < 3; i++) {
        const int32_t z = random_between(r, least, 3 * least / 2);
        corner[i][0] = random_between(r, -z, z) / 2;
        corner[i][1] = random_between(r, -z, z) / 2;
        corner[i][2] = -z;
    }
    for (int k = 0; k < 3 && sliver; k++)
        corner[2][k] =
            (corner[0][k] + corner[1][k]) / 2 + random_between(r, -1, 1);
}

/* The triangle so many times as far, and one in the plane that is `behind`
 * times as far, which hides the same of the picture or more. */
static void place_tilted(int32_t corner[3][3], int32_t times, int32_t behind,
                         bool swapped, bool more)
{
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 3; k++) {
            const int32_t c = corner[i % 3][k];
            const int32_t wide = more ? 2 * c - corner[(i + 1) % 3][k] : c;
            const bool near = (i < 3) == swapped;
            positions[i][k] = (int16_t)(near ? times * c : behind * wide);
        }
}

static bool is_same(const struct pel_scene *scene)
{
    static struct canvas coarse, fine;
    struct pel_frame frame;
    prepare(scene, &frame, 0);
    draw(&frame, 16, &coarse);
    draw(&frame, 32, &fine);
    return canvas_difference(&coarse, &fine) == 0;
}

/* Of near planes ever nearer the last one that 16 bits are enough for has the
 * least to spare; at 1/8 of it they often are not. */
TEST(tilted_planes_and_slivers)
{
    uint32_t allowed = 0, wrong[2] = {0};
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct pel_scene scene = any_view(&c.random);
        struct pel_frame frame;
        int32_t corner[3][3], *near = &scene.camera.near_plane;
        const uint32_t kind = random_word(&c.random);
        const int32_t times = random_between(&c.random, 2, 60);
        const int32_t behind = times + random_between(&c.random, 1, 4);
        const int32_t least = 16000 / 3 / behind;
        any_corners(&c.random, corner, least, kind & 1);
        place_tilted(corner, times, behind, kind & 2, kind & 4);
        scene.camera.projection = PEL_PERSPECTIVE;
        for (*near = least * times * (PEL_UNITS(1) / UNIT / 2);
             prepare(&scene, &frame, least * (behind - times)) == 16;)
            *near -= *near / 8;
        *near += *near / 7 + 1;
        if (prepare(&scene, &frame, least * (behind - times)) == 32)
            continue;
        allowed++;
        if (!is_same(&scene))
            fail_msg("16 bits differ; %s", cases_replay());
        *near /= 8;
        wrong[kind & 1] += !is_same(&scene);
    }
    assert_true(cases_alone() || (wrong[0] > 0 && wrong[1] > 0));
}

TEST(no_gap)
{
    static const pel_length gaps[] = {INT32_MIN, -1, 0};
    struct pel_mesh close = mesh;
    close.position.shift = 14;
    place(30000, 2000, false);
    for (struct cases c = cases_of(100); cases_next(&c);) {
        struct pel_scene scene = any_view(&c.random);
        struct pel_frame frame;
        scene.mesh = &close;
        prepare(&scene, &frame, 0);
        for (int i = 0; i < 3; i++)
            assert_int_equal(pel_scene_depth_bits(&frame, gaps[i]), 32);
    }
}
