/* Coarse meshes of files with values in the world, pixel by pixel against the
 * formulas of light and perspective in extended precision: two of them, or with
 * PEL_WORLD_ALL all, at 800x800 (`make deep-world`). */
#include <unistd.h>

#include "core/format/formats.h"
#include "core/scene/perspective.h"
#include "core/scene/work.h"
#include "files.h"
#include "sim/render/scene.h"
#include "tests/support/reference_scene.h"

static const char *const files[] = {"MD2/faerie.md2",
                                    "3DS/RotatingCube.3DS",
                                    "MD2/sydney.md2",
                                    "MS3D/jeep1.ms3d",
                                    "MS3D/twospheres.ms3d",
                                    "3DS/fels.3ds",
                                    "3DS/test1.3ds",
                                    "LWO/LWO2/ModoExport_vertNormals.lwo",
                                    "LWO/LWO2/hierarchy_smoothed.lwo",
                                    "LWO/LWO2/nonplanar_polygon.lwo",
                                    "LWO/LWO2/boxuv.lwo",
                                    "OBJ/spider.obj",
                                    "PLY/cube.ply",
                                    "COB/dwarf.cob",
                                    "CSM/ThomasFechten.csm",
                                    "HMP/terrain.hmp",
                                    "ASE/ThreeCubesGreen.ASE",
                                    "B3D/WusonBlitz.b3d",
                                    "X/anim_test.x",
                                    "NFF/NFF/dodecahedron.nff",
                                    "Collada/kwxport_test_vcolors.dae"};

enum { FILES = sizeof files / sizeof *files, SIDE = 800, MANY = 8192 };

/* A triangle as it was drawn, and its vertices in the world. */
static struct drawn {
    uint32_t vertex[3];
    struct pel_point at[3];
    real place[3][3], normal[3][3], color[3][3], z[3];
} drawn[MANY];

static uint32_t drawn_count;
static pel_color pixels[SIDE * SIDE], numbers[SIDE * SIDE];

/* Its place in that list, from 1 on. Every triangle is whole: all of a model is
 * seen. */
static const struct pel_paint *number_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    static struct pel_flat flat = PEL_FLAT(0);
    struct drawn *d = &drawn[drawn_count++];
    (void)surface;
    (void)color;
    assert_true(drawn_count < MANY && frame->work->triangle.is_whole);
    for (int i = 0; i < 3; i++) {
        real screen[3];
        const uint32_t vertex = frame->work->triangle.vertex[i];
        const pel_color own = pel_frame_surface(frame, vertex);
        d->at[i] = frame->work->triangle.at[i];
        reference_place(frame->scene, vertex, d->place[i]);
        reference_normal(frame->scene, vertex, d->normal[i]);
        reference_project(frame->scene, d->place[i], screen);
        d->z[i] = screen[2];
        for (int k = 0; k < 3; k++)
            d->color[i][k] = own >> (16 - 8 * k) & 255;
    }
    flat.color = UINT32_C(0xFF000000) | drawn_count;
    return &flat.paint;
}

static void draw(struct scene *scene, pel_color *to)
{
    const struct pel_rect whole = {0, 0, SIDE, SIDE};
    struct pel_surface surface;
    memset(to, 0, sizeof pixels);
    assert_int_equal(
        pel_surface_init(&surface, &pel_xrgb8888, to, sizeof pixels, &whole),
        PEL_OK);
    assert_true(scene_draw(scene, &surface));
}

static void mix(const real w[3], real v[3][3], real out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = w[0] * v[0][k] + w[1] * v[1][k] + w[2] * v[2][k];
}

static void color_at(const struct pel_scene *scene, struct drawn *d,
                     const struct pel_point *pixel, bool phong, real out[3])
{
    real w[3], place[3], normal[3], own[3], sum = 0;
    reference_weights(d->at, pixel->x, pixel->y, w);
    for (int i = 0; i < 3; i++)
        sum += w[i] /= d->z[i];
    for (int i = 0; i < 3; i++)
        w[i] /= sum;
    mix(w, d->color, own);
    if (!phong) {
        memcpy(out, own, sizeof own);
        return;
    }
    mix(w, d->place, place);
    mix(w, d->normal, normal);
    reference_light(scene, place, normal, own, out);
}

struct result {
    uint32_t pixels, wrong; /* by more than 1 */
    int32_t worst;
};

static void compare(const struct pel_scene *scene, bool phong,
                    struct result *result)
{
    for (uint32_t i = 0; !phong && i < drawn_count; i++)
        for (int k = 0; k < 3; k++) {
            const real *c = drawn[i].color[k], own[3] = {c[0], c[1], c[2]};
            reference_light(scene, drawn[i].place[k], drawn[i].normal[k], own,
                            drawn[i].color[k]);
        }
    for (int32_t i = 0; i < SIDE * SIDE; i++) {
        const uint32_t number = numbers[i] & 0xFFFFFFu;
        const struct pel_point pixel = {i % SIDE, i / SIDE};
        real want[3];
        int32_t worst = 0;
        if (number == 0)
            continue;
        color_at(scene, &drawn[number - 1], &pixel, phong, want);
        for (int k = 0; k < 3; k++) {
            const int32_t off = (int32_t)(pixels[i] >> (16 - 8 * k) & 255) -
                                (int32_t)(want[k] + 0.5L);
            worst = pel_max(worst, pel_magnitude(off));
        }
        result->pixels++;
        result->wrong += worst > 1;
        result->worst = pel_max(result->worst, worst);
    }
}

/* As `pel render` shows it, or turned and through a wide lens. */
static void check(const struct model *model, const char *name, bool phong,
                  bool wide)
{
    static const struct pel_shading number = {NULL, NULL, number_paint, 0};
    struct scene_settings settings = scene_default;
    struct scene scene;
    struct result r = {0, 0, 0};
    settings.camera.width = settings.camera.height = SIDE;
    settings.shade = phong ? SCENE_PHONG : SCENE_GOURAUD;
    settings.lit = SCENE_LIT;
    settings.in_world = true;
    settings.order = SCENE_ZBUFFER32;
    if (wide) {
        settings.camera.focal = 15;
        settings.turn[0] = 5000;
        settings.turn[1] = 12345;
    }
    assert_true(scene_init(&scene, model));
    assert_true(scene_prepare(&scene, &settings));
    draw(&scene, pixels);
    drawn_count = 0;
    scene.core.shading = &number;
    draw(&scene, numbers);
    compare(&scene.core, phong, &r);
    print_message("%-36s %-7s %6u px, %.3f %% within 1, all within %d\n", name,
                  phong ? "Phong" : "Gouraud", r.pixels,
                  100 - 100.0 * r.wrong / r.pixels, (int)r.worst);
    assert_true(r.pixels > SIDE * SIDE / 100);
    if ((uint64_t)r.wrong * 1000 > r.pixels)
        fail_msg("%s: %u of %u pixels are off by more than 1", name, r.wrong,
                 r.pixels);
    scene_free(&scene);
}

TEST(coarse_meshes_in_the_world)
{
    const char *models = getenv("PEL_MODELS");
    const int count = getenv("PEL_WORLD_ALL") ? FILES : 2;
    for (int i = 0; i < count; i++) {
        struct model_source source = {.without_texture = true};
        struct model model;
        char path[4096];
        snprintf(path, sizeof path, "%s/%s",
                 models ? models : "/usr/share/assimp/models", files[i]);
        source.path = path;
        if (access(path, R_OK) != 0)
            fail_msg("%s is missing: the package assimp-testmodels brings it",
                     path);
        assert_true(model_load(&model, &source));
        for (int k = 0; k < 4; k++)
            check(&model, files[i], k % 2 == 1, k >= 2);
        model_free(&model);
    }
}
