/* Methods that are chosen by a tolerance: their shares, the cost of a picture
 * and its largest error against the exact one. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <pel/pel.h>

#include "core/scene/work.h"

#include "../timing.h"
#include "../lighting.h"
#include "cases.h"

/* A turned vase. */
enum { AROUND = 48, DOWN = 32, SIDE = 256 };
enum { VERTICES = AROUND * (DOWN + 1), TRIANGLES = 2 * AROUND * DOWN };

struct stage {
    struct pel_scene scene;
    struct pel_mesh mesh;
    int16_t positions[VERTICES][3], normals[VERTICES][3];
    uint16_t indices[TRIANGLES][3];
    struct pel_surface surface;
    uint32_t pixels[SIDE * SIDE], exact[SIDE * SIDE];
    uint64_t scratch[VERTICES * 3 + TRIANGLES * 2 + 1024];
};

static void make_vertex(int16_t at[3], int row, int column)
{
    const double t = row / (double)DOWN;
    const double turn = column * (6.283185307179586 / AROUND);
    const double radius = .4 + .2 * sin(7 * t + 1);
    at[0] = (int16_t)lround(16384 * radius * cos(turn));
    at[1] = (int16_t)lround(16384 * (1.4 * t - .7));
    at[2] = (int16_t)lround(16384 * radius * sin(turn));
}

static void make_mesh(struct stage *s)
{
    for (int i = 0; i < VERTICES; i++)
        make_vertex(s->positions[i], i / AROUND, i % AROUND);
    for (int i = 0; i < TRIANGLES / 2; i++) {
        const int row = i / AROUND, next = row * AROUND + (i + 1) % AROUND;
        const uint16_t a = (uint16_t)i, b = (uint16_t)(i + AROUND);
        const uint16_t c = (uint16_t)next, d = (uint16_t)(next + AROUND);
        const uint16_t pair[2][3] = {{a, b, c}, {c, b, d}};
        memcpy(s->indices[2 * i], pair, sizeof pair);
    }
    s->mesh = (struct pel_mesh){.vertices = VERTICES,
                                .triangles = TRIANGLES,
                                .position = {.step = 1, .shift = 14},
                                .positions = (const int16_t(*)[3])s->positions,
                                .indices16 = (const uint16_t(*)[3])s->indices};
    if (pel_mesh_normals(&s->mesh, s->normals, s->scratch, sizeof s->scratch))
        method_fail("a mesh is refused", "take legal indices");
    s->mesh.normals16 = (const int16_t(*)[3])s->normals;
}

static void set_scene(struct stage *s)
{
    const struct pel_rect all = {0, 0, SIDE, SIDE};
    make_mesh(s);
    s->scene = (struct pel_scene){
        .mesh = &s->mesh,
        .camera = {.eye = {PEL_UNITS(.5), PEL_UNITS(.75), PEL_UNITS(1.5)},
                   .up = {0, 1, 0},
                   .near_plane = PEL_UNITS(1) / 64,
                   .focal = 50,
                   .sensor = {45, 45}},
        .viewport = all,
        .lighting = &lighting,
        .color = PEL_RGB(220, 180, 140),
        .sort = &pel_depth_sort,
        .cull = PEL_CULL_BACK};
    if (pel_surface_init(&s->surface, &pel_xrgb8888, s->pixels,
                         sizeof s->pixels, &all))
        method_fail("a picture is no surface", "take legal bounds");
}

/* Sets it up and draws it, CPU time in ns. */
static double draw(struct stage *s)
{
    struct pel_frame frame;
    const double start = timing_now();
    pel_clear(&s->surface, PEL_RGB(0, 0, 0));
    if (pel_scene_prepare(&frame, &s->scene, s->scratch, sizeof s->scratch))
        method_fail("a scene is refused", "take a legal one");
    pel_scene_draw(&frame, &s->surface);
    return timing_now() - start;
}

static double error_of(const struct stage *s)
{
    double worst = 0;
    for (int i = 0; i < 3 * SIDE * SIDE; i++) {
        const int shift = 8 * (i % 3);
        const int shown = (int)(s->pixels[i / 3] >> shift & 255);
        worst = fmax(worst, abs(shown - (int)(s->exact[i / 3] >> shift & 255)));
    }
    return worst;
}

static uint32_t triangles[PEL_METHODS];

static const struct pel_paint *counted_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    const struct pel_paint *paint =
        pel_shade_chosen.paint(frame, surface, color);
    triangles[frame->work->triangle.method]++;
    return paint;
}

static void put_shares(struct atlas *a, struct stage *s, double tolerance)
{
    static const char *const names[PEL_METHODS] = {"flat", "gouraud", "phong"};
    struct pel_shading counted = pel_shade_chosen;
    double all = 0;
    counted.paint = counted_paint;
    memset(triangles, 0, sizeof triangles);
    s->scene.shading = &counted;
    draw(s);
    for (int i = 0; i < PEL_METHODS; i++)
        all += triangles[i];
    for (int i = 0; i < PEL_METHODS; i++)
        atlas_put(a, figure_of(names[i], tolerance, "share",
                               100 * triangles[i] / all, "%"));
}

/* The time of a picture, in percent of the exact one's, which is measured in
 * turns with it. */
static void put_cost(struct atlas *a, struct stage *s, double tolerance)
{
    enum { REPEATS = 5 };
    double share[REPEATS];
    for (int i = 0; i < REPEATS; i++) {
        s->scene.shading = &pel_shade_phong;
        const double exact = draw(s);
        s->scene.shading = &pel_shade_chosen;
        share[i] = 100 * draw(s) / exact;
    }
    atlas_put(a, figure_spread("chosen", tolerance, "cost",
                               timing_quartiles(share, REPEATS), "%"));
}

static const double tolerances[] = {0, .5, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32};
enum { TOLERANCES = sizeof tolerances / sizeof *tolerances };

void atlas_tolerance_time(struct atlas *a)
{
    static struct stage s;
    set_scene(&s);
    for (int i = 0; i < TOLERANCES; i++) {
        s.scene.tolerance = (int32_t)(256 * tolerances[i]);
        put_cost(a, &s, tolerances[i]);
    }
}

void atlas_tolerance(struct atlas *a)
{
    static struct stage s;
    set_scene(&s);
    s.scene.shading = &pel_shade_phong;
    draw(&s);
    memcpy(s.exact, s.pixels, sizeof s.exact);
    for (int i = 0; i < TOLERANCES; i++) {
        s.scene.tolerance = (int32_t)(256 * tolerances[i]);
        put_shares(a, &s, tolerances[i]);
        atlas_put_bound(a,
                        figure_of("chosen", tolerances[i], "error_max",
                                  error_of(&s), "step"),
                        ceil(tolerances[i]));
    }
}
