/* Meshes and cameras: what is refused, where points land, what is clipped. */
#include "tests/support/check.h"

#include <math.h>

#include "mesh_messages.h"
#include "sim/camera.h"

static void set(struct mesh *mesh, uint32_t i, double x, double y, double z)
{
    const struct mesh_vertex v = {
        {x, y, z}, {0}, {x, y}, PEL_RGB(10 * i, 20, 30)};
    mesh->vertex[i] = v;
}

/* A square of two triangles in the plane z = 0, counter-clockwise. */
static void make_square(struct mesh *mesh)
{
    assert_true(mesh_init(mesh, 4, 2));
    set(mesh, 0, -1, -1, 0);
    set(mesh, 1, 1, -1, 0);
    set(mesh, 2, 1, 1, 0);
    set(mesh, 3, -1, 1, 0);
    const uint32_t index[2][3] = {{0, 1, 2}, {0, 2, 3}};
    memcpy(mesh->triangle, index, sizeof(index));
}

static void refuse(const struct mesh *mesh, const char *message)
{
    struct messages m;
    messages_begin(&m);
    bool taken = mesh_check(mesh, "a.obj");
    messages_end(&m);
    assert_false(taken);
    assert_string_equal(m.text, message);
}

static void test_check(void **state)
{
    struct mesh mesh;
    (void)state;
    make_square(&mesh);
    assert_true(mesh_check(&mesh, "a.obj"));
    mesh.triangle[1][2] = 4;
    refuse(&mesh, "pel: a.obj: triangle 1 names vertex 4; the mesh has 4, "
                  "counted from 0\n");
    mesh.triangle[1][2] = UINT32_MAX;
    refuse(&mesh, "pel: a.obj: triangle 1 names vertex 4294967295; the mesh "
                  "has 4, counted from 0\n");
    mesh.triangle[1][2] = 3;
    mesh.vertex[2].position[1] = (double)NAN;
    refuse(&mesh, "pel: a.obj: vertex 2 lies at (1, nan, 0); legal are "
                  "coordinates up to 1e+15\n");
    mesh.vertex[2].position[1] = 1;
    mesh.vertex[3].uv[0] = (double)INFINITY;
    refuse(&mesh, "pel: a.obj: vertex 3 has uv (inf, 1); legal is -1e6 to "
                  "1e6\n");
    mesh_free(&mesh);
}

static void test_normals(void **state)
{
    struct mesh mesh;
    (void)state;
    make_square(&mesh);
    mesh.triangle[1][1] = 0; /* without area */
    mesh_normals(&mesh);
    for (int k = 0; k < 3; k++) {
        assert_int_equal((int)mesh.vertex[0].normal[k], k == 2);
        assert_int_equal((int)mesh.vertex[3].normal[k], 0);
    }
    mesh_free(&mesh);
}

/* 100x50 pixels of a 40x20 mm sensor at 10 mm: 25 px at a slope of 1. */
static struct camera make_camera(double distance)
{
    struct camera camera = camera_default;
    camera.width = 100;
    camera.height = 50;
    camera.sensor[0] = 40;
    camera.sensor[1] = 20;
    camera.focal = 10;
    camera.eye[2] = distance;
    camera.has_eye = camera.has_target = camera.has_sensor = true;
    return camera;
}

static void test_formula(void **state)
{
    static const int32_t expected[4][2] = {
        {PEL_PX(50) - 3200, PEL_PX(25) + 3200},
        {PEL_PX(50) + 3200, PEL_PX(25) + 3200},
        {PEL_PX(50) + 3200, PEL_PX(25) - 3200},
        {PEL_PX(50) - 3200, PEL_PX(25) - 3200}};
    struct mesh mesh;
    struct pel2d flat;
    uint32_t clipped;
    struct camera camera = make_camera(2);
    (void)state;
    make_square(&mesh);
    assert_true(camera_frame(&camera, &mesh));
    assert_true(mesh_project(&mesh, &camera, &flat, &clipped));
    assert_int_equal(clipped, 0);
    assert_int_equal(flat.vertices, 4);
    for (uint32_t i = 0; i < 4; i++) {
        assert_int_equal(flat.vertex[i].at.x, expected[i][0]);
        assert_int_equal(flat.vertex[i].at.y, expected[i][1]);
        assert_int_equal(flat.vertex[i].depth.limb[0], 2);
        assert_int_equal(flat.vertex[i].color, mesh.vertex[i].color);
    }
    pel2d_free(&flat);
    mesh_free(&mesh);
}

/* The square lies flat, 1 below the eye, half of it before and half behind: the
 * part behind is cut off. All of it behind: nothing is left. */
static void test_behind(void **state)
{
    struct mesh mesh;
    struct pel2d flat;
    uint32_t clipped;
    struct camera camera = make_camera(0);
    (void)state;
    make_square(&mesh);
    for (uint32_t i = 0; i < 4; i++) { /* from z = 1 to z = -1, below the eye */
        mesh.vertex[i].position[2] = -mesh.vertex[i].position[1];
        mesh.vertex[i].position[1] = -1;
    }
    camera.target[2] = -1;
    assert_true(camera_frame(&camera, &mesh));
    assert_true(mesh_project(&mesh, &camera, &flat, &clipped));
    assert_int_equal(clipped, 2);
    assert_true(flat.triangles >= 2);
    for (uint32_t i = 0; i < flat.vertices; i++) {
        assert_true(abs(flat.vertex[i].at.x) <= PEL_PX(32000));
        assert_true(flat.vertex[i].at.y <= PEL_PX(32000));
        assert_true(flat.vertex[i].at.y >= PEL_PX(50)); /* 45 degrees down */
    }
    pel2d_free(&flat);
    mesh.vertex[0].position[2] = mesh.vertex[1].position[2] = 5;
    mesh.vertex[2].position[2] = mesh.vertex[3].position[2] = 6;
    assert_true(mesh_project(&mesh, &camera, &flat, &clipped));
    assert_int_equal(clipped, 2);
    assert_int_equal(flat.triangles, 0);
    pel2d_free(&flat);
    mesh_free(&mesh);
}

static uint64_t next(uint64_t *seed)
{
    *seed = *seed * UINT64_C(6364136223846793005) + 1442695040888963407u;
    return *seed >> 24;
}

static double random_in(uint64_t *seed, double limit)
{
    return ((double)(next(seed) % 2000001) / 1e6 - 1) * limit;
}

/* Cameras in the midst of random triangles: nothing out of range comes out, and
 * indices stay inside. */
static void test_any_camera(void **state)
{
    uint64_t seed = 7;
    (void)state;
    for (int round = 0; round < 300; round++) {
        struct mesh mesh;
        struct pel2d flat;
        uint32_t clipped;
        struct camera camera = make_camera(0);
        double size = pow(10, (double)(next(&seed) % 25) - 9);
        assert_true(mesh_init(&mesh, 60, 20));
        for (uint32_t i = 0; i < 60; i++) {
            set(&mesh, i, random_in(&seed, size), random_in(&seed, size),
                random_in(&seed, size));
            mesh.triangle[i / 3][i % 3] = i;
        }
        for (int k = 0; k < 3; k++) {
            camera.eye[k] = random_in(&seed, size);
            camera.target[k] = random_in(&seed, size);
        }
        assert_true(camera_frame(&camera, &mesh));
        assert_true(mesh_project(&mesh, &camera, &flat, &clipped));
        for (uint32_t i = 0; i < flat.vertices; i++)
            assert_true(pel_points_legal(&flat.vertex[i].at, 1));
        for (uint32_t i = 0; i < flat.triangles; i++)
            for (int k = 0; k < 3; k++)
                assert_true(flat.triangle[i][k] < flat.vertices);
        pel2d_free(&flat);
        mesh_free(&mesh);
    }
}

/* By default everything is in the picture and touches the margin. */
static void test_framing(void **state)
{
    static const int size[][2] = {{1200, 1200}, {640, 480}, {100, 900}};
    struct mesh mesh;
    (void)state;
    assert_true(mesh_load(&mesh, MESH_BUILTIN));
    for (int i = 0; i < 3; i++) {
        struct camera camera = camera_default;
        struct pel2d flat;
        uint32_t clipped;
        double reach = 0;
        camera.width = size[i][0];
        camera.height = size[i][1];
        assert_true(camera_frame(&camera, &mesh));
        assert_true(mesh_project(&mesh, &camera, &flat, &clipped));
        assert_int_equal(clipped, 0);
        for (uint32_t k = 0; k < flat.vertices; k++) {
            double x = flat.vertex[k].at.x / 128.0 / camera.width - 1;
            double y = flat.vertex[k].at.y / 128.0 / camera.height - 1;
            reach = fmax(reach, fmax(fabs(x), fabs(y)));
        }
        assert_true(reach <= 0.91 && reach >= 0.89);
        pel2d_free(&flat);
    }
    mesh_free(&mesh);
}

static void test_camera_refused(void **state)
{
    struct mesh mesh;
    struct messages m;
    struct camera same = make_camera(0), along = make_camera(2);
    (void)state;
    along.up[1] = 0;
    along.up[2] = 1;
    make_square(&mesh);
    messages_begin(&m);
    bool taken = camera_frame(&same, &mesh) || camera_frame(&along, &mesh);
    messages_end(&m);
    assert_false(taken);
    assert_non_null(strstr(m.text, "--eye is --target, or --up points along"));
    mesh_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_check),          cmocka_unit_test(test_normals),
        cmocka_unit_test(test_formula),        cmocka_unit_test(test_behind),
        cmocka_unit_test(test_any_camera),     cmocka_unit_test(test_framing),
        cmocka_unit_test(test_camera_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
