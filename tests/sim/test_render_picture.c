/* Whole meshes against a renderer of the test's own: it reads the pel2d file
 * itself, sorts by exact sums, and judges and colors every pixel in 128-bit
 * arithmetic. Flat pictures are equal; Gouraud's differ by 1 at most. */
#include "tests/support/check.h"

#include "files.h"
#include "sim/image/canvas.h"
#include "sim/render/painter.h"
#include "sim/render/scene_pel2d.h"
#include "core/format/formats.h"
#include "core/raster/rectangle.h"
#include "tests/support/reference.h"

enum { SIZE = 1200 };

struct corner {
    struct pel_point at;
    pel_color color;
    int64_t depth;
};

struct face {
    struct corner corner[3];
    int64_t depth; /* sum of three */
    uint32_t index;
};

/* "-1.25" as a whole number of 10^-digits. */
static int64_t scaled(const char *text, int digits)
{
    bool negative = *text == '-';
    int64_t value = 0;
    int after = -1;
    for (text += negative; *text; text++) {
        if (*text == '.') {
            after = 0;
            continue;
        }
        value = value * 10 + (*text - '0');
        after += after >= 0;
    }
    for (after = after < 0 ? 0 : after; after < digits; after++)
        value *= 10;
    assert_int_equal(after, digits);
    return negative ? -value : value;
}

static void read_corner(FILE *file, struct corner *c)
{
    char x[64], y[64], depth[64];
    unsigned r, g, b;
    assert_int_equal(fscanf(file, "%63s %63s %u %u %u %63s %*s %*s", x, y, &r,
                            &g, &b, depth),
                     6);
    c->at.x = (int32_t)(scaled(x, 8) / 390625);
    c->at.y = (int32_t)(scaled(y, 8) / 390625);
    c->color = PEL_RGB(r, g, b);
    c->depth = scaled(depth, 0);
}

static int farther_first(const void *left, const void *right)
{
    const struct face *a = left, *b = right;
    if (a->depth != b->depth)
        return a->depth > b->depth ? -1 : 1;
    return a->index < b->index ? -1 : 1;
}

static struct face *read_faces(const char *path, uint32_t *faces)
{
    uint32_t corners, index;
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    assert_int_equal(fscanf(file, "pel2d %u %u", &corners, faces), 2);
    struct corner *corner = calloc(corners, sizeof(*corner));
    struct face *face = calloc(*faces, sizeof(*face));
    assert_true(corner && face);
    for (uint32_t i = 0; i < corners; i++)
        read_corner(file, &corner[i]);
    for (uint32_t i = 0; i < *faces; i++) {
        face[i].index = i;
        for (int k = 0; k < 3; k++) {
            assert_int_equal(fscanf(file, "%u", &index), 1);
            face[i].corner[k] = corner[index];
            face[i].depth += corner[index].depth;
        }
    }
    fclose(file);
    free(corner);
    qsort(face, *faces, sizeof(*face), farther_first);
    return face;
}

static pel_color rounded_color(const struct pel_point v[3],
                               const pel_color c[3], int32_t x, int32_t y)
{
    pel_color color = PEL_RGB(0, 0, 0);
    for (int k = 0; k < 3; k++) {
        struct fraction f = reference_channel_at(v, c, k, x, y);
        color |= (pel_color)((2 * f.n + f.d) / (2 * f.d)) << 8 * k;
    }
    return color;
}

static pel_color mean_color(const pel_color c[3])
{
    pel_color color = PEL_RGB(0, 0, 0);
    for (int k = 0; k < 3; k++) {
        unsigned sum = 0;
        for (int i = 0; i < 3; i++)
            sum += c[i] >> 8 * k & 255;
        color |= (pel_color)((2 * sum + 3) / 6) << 8 * k;
    }
    return color;
}

static void draw_face(const struct face *face, enum painter_shade shade,
                      struct picture *picture)
{
    struct pel_point v[3];
    pel_color c[3];
    int32_t x0 = SIZE, y0 = SIZE, x1 = 0, y1 = 0;
    for (int k = 0; k < 3; k++) {
        v[k] = face->corner[k].at;
        c[k] = face->corner[k].color;
        x0 = pel_min(x0, v[k].x >> 8);
        y0 = pel_min(y0, v[k].y >> 8);
        x1 = pel_max(x1, (v[k].x >> 8) + 1);
        y1 = pel_max(y1, (v[k].y >> 8) + 1);
    }
    for (int32_t y = pel_max(y0, 0); y < pel_min(y1, SIZE); y++)
        for (int32_t x = pel_max(x0, 0); x < pel_min(x1, SIZE); x++)
            if (reference_triangle_at(v, x, y))
                picture_row(picture, y)[x] = shade == PAINTER_FLAT
                                                 ? mean_color(c)
                                                 : rounded_color(v, c, x, y);
}

static void draw_pel(const char *path, enum painter_shade shade,
                     struct picture *picture)
{
    struct pel2d flat;
    struct canvas canvas;
    struct painter painter = {.shade = shade};
    assert_true(pel2d_load(&flat, path));
    assert_true(canvas_init(&canvas, &pel_rgb888, SIZE, SIZE));
    pel_clear(&canvas.surface, PEL_RGB(255, 255, 255));
    assert_true(painter_init(&painter, &flat));
    painter_draw(&canvas.surface, &painter);
    assert_true(canvas_picture(&canvas, picture));
    painter_free(&painter);
    canvas_free(&canvas);
    pel2d_free(&flat);
}

static int difference(pel_color a, pel_color b)
{
    int worst = 0;
    for (int k = 0; k < 24; k += 8)
        worst = pel_max(worst, abs((int)(a >> k & 255) - (int)(b >> k & 255)));
    return worst;
}

static void compare(const char *path, enum painter_shade shade, int tolerance)
{
    struct picture expected, got;
    uint32_t faces, painted = 0;
    struct face *face = read_faces(path, &faces);
    assert_true(picture_init(&expected, SIZE, SIZE, PEL_RGB(255, 255, 255)));
    for (uint32_t i = 0; i < faces; i++)
        draw_face(&face[i], shade, &expected);
    draw_pel(path, shade, &got);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            pel_color a = picture_row(&expected, y)[x];
            pel_color b = picture_row(&got, y)[x];
            painted += a != PEL_RGB(255, 255, 255);
            if (difference(a, b) > tolerance)
                fail_msg("(%d, %d): expected %06x, got %06x", x, y,
                         a & 0xFFFFFFu, b & 0xFFFFFFu);
        }
    assert_true(painted > SIZE * SIZE / 8);
    picture_free(&expected);
    picture_free(&got);
    free(face);
}

static void project(const char *mesh, struct pel2d *flat)
{
    const struct model_source source = {.path = mesh};
    struct scene_settings settings = scene_default;
    struct model model;
    struct scene scene;
    uint32_t clipped;
    settings.mapping = SCENE_MAP_VERTICES;
    assert_true(model_load(&model, &source));
    assert_true(scene_init(&scene, &model));
    assert_true(scene_prepare(&scene, &settings));
    assert_true(scene_project(&scene, flat, &clipped));
    assert_int_equal(clipped, 0);
    scene_free(&scene);
    model_free(&model);
}

/* The picture of a mesh, through a pel2d file, in both shadings. */
static void compare_mesh(const char *mesh)
{
    struct pel2d flat;
    char *path = file_with("", 0);
    project(mesh, &flat);
    assert_true(pel2d_save(&flat, path));
    pel2d_free(&flat);
    compare(path, PAINTER_FLAT, 0);
    compare(path, PAINTER_GOURAUD, 1);
    unlink(path);
    free(path);
}

TEST(vase)
{
    compare_mesh(MESH_BUILTIN);
}

TEST(duck)
{
    const char *models = getenv("PEL_MODELS");
    char path[4096];
    snprintf(path, sizeof(path), "%s/Collada/duck.dae",
             models ? models : "/usr/share/assimp/models");
    if (!mesh_files_supported() || access(path, R_OK) != 0)
        fail_msg("%s or assimp is missing: the packages assimp-testmodels and "
                 "libassimp-dev bring them",
                 path);
    compare_mesh(path);
}
