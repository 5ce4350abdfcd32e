/* Meshes, cameras and scenes: what is refused, where points land, what is
 * clipped, in which scale the world goes to core. */
#include "tests/support/cases.h"
#include "tests/support/check.h"

#include <math.h>

#include "files.h"
#include "sim/render/scene_pel2d.h"

static void set(struct mesh *mesh, uint32_t i, double x, double y, double z)
{
    const struct mesh_vertex v = {
        {x, y, z}, {0}, {x, y}, PEL_RGB(10 * i, 20, 30)};
    mesh->vertex[i] = v;
}

/* A square of two triangles in the plane z = 0, counter-clockwise. */
static void make_square(struct mesh *mesh)
{
    assert_true(mesh_init(mesh, 4, 2, 1));
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

TEST(check)
{
    struct mesh mesh;
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

TEST(normals)
{
    struct mesh mesh;
    make_square(&mesh);
    mesh.triangle[1][1] = 0; /* without area */
    assert_true(mesh_normals(&mesh, MESH_CREASE));
    for (int k = 0; k < 3; k++) {
        assert_int_equal((int)mesh.vertex[0].normal[k], k == 2);
        assert_int_equal((int)mesh.vertex[3].normal[k], 0);
    }
    mesh_free(&mesh);
}

/* The sides of a sheet, which has each triangle twice, do not cancel out; an
 * edge of 90 degrees is one for a smaller crease. */
TEST(creases)
{
    struct mesh mesh;
    make_square(&mesh);
    for (int k = 0; k < 3; k++)
        mesh.triangle[1][k] = mesh.triangle[0][2 - k];
    assert_true(mesh_normals(&mesh, MESH_CREASE));
    assert_int_equal(mesh.vertices, 6);
    for (uint32_t i = 0; i < 6; i++)
        assert_int_equal((int)mesh.vertex[i].normal[2], i < 3 ? 1 : -1);
    mesh_free(&mesh);
    for (int split = 0; split < 2; split++) {
        make_square(&mesh);
        mesh.vertex[3].position[0] = 0.5;
        mesh.vertex[3].position[1] = 0.5;
        mesh.vertex[3].position[2] = 1;
        assert_true(mesh_normals(&mesh, split ? 89 : 90));
        assert_int_equal(mesh.vertices, split ? 6 : 4);
        mesh_free(&mesh);
    }
}

/* 100x50 pixels of a 40x20 mm sensor at 10 mm: 25 px at a slope of 1. */
static struct scene_settings make_settings(double distance)
{
    struct scene_settings s = scene_default;
    s.camera.width = 100;
    s.camera.height = 50;
    s.camera.sensor[0] = 40;
    s.camera.sensor[1] = 20;
    s.camera.focal = 10;
    s.camera.eye[2] = distance;
    s.camera.has_eye = s.camera.has_target = s.camera.has_sensor = true;
    s.mapping = SCENE_MAP_VERTICES;
    s.lit = SCENE_UNLIT;
    return s;
}

/* A mesh as the scene shows it; `units` is the world's scale. */
struct shown {
    struct pel2d flat;
    uint32_t clipped;
    double units;
};

static bool show(const struct mesh *mesh, const struct scene_settings *settings,
                 struct shown *shown)
{
    struct model model;
    struct scene scene;
    assert_true(model_make(&model, mesh, 0));
    assert_true(scene_init(&scene, &model));
    const bool done = scene_prepare(&scene, settings) &&
                      scene_project(&scene, &shown->flat, &shown->clipped);
    shown->units = scene.units;
    scene_free(&scene);
    model_free(&model);
    return done;
}

/* The square at any size, seen from twice its size: always the same places, to
 * the sub-pixel. */
TEST(formula)
{
    static const int32_t expected[4][2] = {
        {PEL_PX(50) - 3200, PEL_PX(25) + 3200},
        {PEL_PX(50) + 3200, PEL_PX(25) + 3200},
        {PEL_PX(50) + 3200, PEL_PX(25) - 3200},
        {PEL_PX(50) - 3200, PEL_PX(25) - 3200}};
    for (int exponent = -30; exponent <= 45; exponent++) {
        const double size = ldexp(1, exponent);
        const struct scene_settings s = make_settings(2 * size);
        struct mesh mesh;
        struct shown shown;
        make_square(&mesh);
        for (uint32_t i = 0; i < 4; i++)
            for (int k = 0; k < 3; k++)
                mesh.vertex[i].position[k] *= size;
        assert_true(show(&mesh, &s, &shown));
        assert_int_equal(shown.clipped, 0);
        assert_int_equal(shown.flat.vertices, 4);
        const bool as_it_is = exponent >= -5 && exponent <= 13;
        assert_int_equal(shown.units == 1, as_it_is);
        for (uint32_t i = 0; i < 4; i++) {
            const struct pel2d_vertex *v = &shown.flat.vertex[i];
            assert_in_range(v->at.x, expected[i][0] - 1, expected[i][0] + 1);
            assert_in_range(v->at.y, expected[i][1] - 1, expected[i][1] + 1);
            assert_int_equal(v->depth.limb[0],
                             shown.flat.vertex[0].depth.limb[0]);
            assert_int_equal(v->color, mesh.vertex[i].color);
        }
        pel2d_free(&shown.flat);
        mesh_free(&mesh);
    }
}

/* Orthographic: 40 by 20 units on 100 by 50 pixels, at any distance. */
TEST(orthographic)
{
    struct scene_settings s = make_settings(300);
    struct mesh mesh;
    struct shown shown;
    s.camera.projection = PEL_ORTHOGRAPHIC;
    make_square(&mesh);
    assert_true(show(&mesh, &s, &shown));
    assert_int_equal(shown.flat.vertices, 4);
    assert_int_equal(shown.flat.vertex[0].at.x, PEL_PX(50) - 640);
    assert_int_equal(shown.flat.vertex[0].at.y, PEL_PX(25) + 640);
    assert_int_equal(shown.flat.vertex[2].at.x, PEL_PX(50) + 640);
    assert_int_equal(shown.flat.vertex[2].at.y, PEL_PX(25) - 640);
    pel2d_free(&shown.flat);
    mesh_free(&mesh);
}

/* A quarter of a turn around z takes each corner to the next one. */
TEST(turn)
{
    const struct scene_settings s = make_settings(2);
    struct scene_settings turned = s;
    struct mesh mesh;
    struct shown before, after;
    turned.turn[2] = 16384;
    make_square(&mesh);
    for (uint32_t i = 0; i < 4; i++)
        mesh.vertex[i].position[0] += 0.25; /* the middle stays */
    assert_true(show(&mesh, &s, &before));
    assert_true(show(&mesh, &turned, &after));
    for (uint32_t i = 0; i < 4; i++) {
        const struct pel_point *to = &before.flat.vertex[(i + 1) % 4].at;
        assert_in_range(after.flat.vertex[i].at.x, to->x - 1, to->x + 1);
        assert_in_range(after.flat.vertex[i].at.y, to->y - 1, to->y + 1);
    }
    pel2d_free(&before.flat);
    pel2d_free(&after.flat);
    mesh_free(&mesh);
}

/* The square lies flat, 1 below the eye, half of it before and half behind: the
 * part behind is cut off. All of it behind: nothing is left. */
TEST(behind)
{
    struct mesh mesh;
    struct shown shown;
    struct scene_settings s = make_settings(0);
    make_square(&mesh);
    for (uint32_t i = 0; i < 4; i++) { /* from z = 1 to z = -1, below the eye */
        mesh.vertex[i].position[2] = -mesh.vertex[i].position[1];
        mesh.vertex[i].position[1] = -1;
    }
    s.camera.target[2] = -1;
    assert_true(show(&mesh, &s, &shown));
    assert_int_equal(shown.clipped, 2);
    assert_true(shown.flat.triangles >= 2);
    for (uint32_t i = 0; i < shown.flat.vertices; i++)
        assert_true(shown.flat.vertex[i].at.y >= PEL_PX(50)); /* 45 degrees */
    pel2d_free(&shown.flat);
    mesh.vertex[0].position[2] = mesh.vertex[1].position[2] = 5;
    mesh.vertex[2].position[2] = mesh.vertex[3].position[2] = 6;
    assert_true(show(&mesh, &s, &shown));
    assert_int_equal(shown.clipped, 2);
    assert_int_equal(shown.flat.triangles, 0);
    pel2d_free(&shown.flat);
    mesh_free(&mesh);
}

static double random_in(struct random *r, double limit)
{
    return ((double)(random_word(r) % 2000001) / 1e6 - 1) * limit;
}

/* Cameras in the midst of random triangles: nothing out of range comes out, and
 * indices stay inside. */
TEST(any_camera)
{
    struct random r = {7};
    for (int round = 0; round < 300; round++) {
        struct mesh mesh;
        struct shown shown;
        struct scene_settings s = make_settings(0);
        double size = pow(10, (double)(random_word(&r) % 25) - 9);
        assert_true(mesh_init(&mesh, 60, 20, 1));
        for (uint32_t i = 0; i < 60; i++) {
            set(&mesh, i, random_in(&r, size), random_in(&r, size),
                random_in(&r, size));
            mesh.triangle[i / 3][i % 3] = i;
        }
        for (int k = 0; k < 3; k++) {
            s.camera.eye[k] = random_in(&r, size);
            s.camera.target[k] = random_in(&r, size);
        }
        assert_true(show(&mesh, &s, &shown));
        for (uint32_t i = 0; i < shown.flat.vertices; i++)
            assert_true(pel_points_legal(&shown.flat.vertex[i].at, 1));
        for (uint32_t i = 0; i < shown.flat.triangles; i++)
            for (int k = 0; k < 3; k++)
                assert_true(shown.flat.triangle[i][k] < shown.flat.vertices);
        pel2d_free(&shown.flat);
        mesh_free(&mesh);
    }
}

/* How near to the sides the vertices come: 1 is there. */
static double reach_of(const struct pel2d *flat, const int size[2])
{
    double reach = 0;
    for (uint32_t k = 0; k < flat->vertices; k++) {
        double x = flat->vertex[k].at.x / 128.0 / size[0] - 1;
        double y = flat->vertex[k].at.y / 128.0 / size[1] - 1;
        reach = fmax(reach, fmax(fabs(x), fabs(y)));
    }
    return reach;
}

/* By default everything is in the picture and touches the margin. */
TEST(framing)
{
    static const int size[][2] = {{1200, 1200}, {640, 480}, {100, 900}};
    struct mesh mesh;
    assert_true(mesh_load(&mesh, MESH_BUILTIN));
    for (int i = 0; i < 6; i++) {
        struct scene_settings s = scene_default;
        struct shown shown;
        s.camera.width = size[i / 2][0];
        s.camera.height = size[i / 2][1];
        s.camera.projection = i % 2 ? PEL_ORTHOGRAPHIC : PEL_PERSPECTIVE;
        assert_true(show(&mesh, &s, &shown));
        assert_int_equal(shown.clipped, 0);
        double reach = reach_of(&shown.flat, size[i / 2]);
        assert_true(reach <= 0.91 && reach >= 0.89);
        pel2d_free(&shown.flat);
    }
    mesh_free(&mesh);
}

/* Is it refused with that message? */
static void refuse_settings(const struct scene_settings *s, const char *text)
{
    struct mesh mesh;
    struct shown shown;
    struct messages m;
    make_square(&mesh);
    messages_begin(&m);
    bool taken = show(&mesh, s, &shown);
    messages_end(&m);
    assert_false(taken);
    if (!strstr(m.text, text))
        fail_msg("no '%s' in: %s", text, m.text);
    mesh_free(&mesh);
}

TEST(refused)
{
    struct scene_settings same = make_settings(0), along = make_settings(2);
    struct scene_settings lens = make_settings(2), phong = make_settings(2);
    along.camera.up[1] = 0;
    along.camera.up[2] = 1;
    lens.camera.focal = 1e6;
    phong.shade = SCENE_PHONG;
    refuse_settings(&same, "eye and target are one place, or up points");
    refuse_settings(&along, "eye and target are one place, or up points");
    refuse_settings(&lens, "make more than 65536 or less than 1/256 pixel");
    refuse_settings(&phong, "expected flat or gouraud without light");
}
