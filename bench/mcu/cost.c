/* Holds the bounds of core/raster/cost.h and core/scene/cost.h against what
 * random triangles take: `used` is the largest share of a bound, `median` that
 * of the bound by what is used, both in percent. COST_TRIANGLES of each. The
 * bounds are those of -O2. */
#include "core/scene/cost.h"

#include <stdio.h>

#include "bench/lighting.h"
#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "core/pel.h"

#ifndef COST_TRIANGLES
#define COST_TRIANGLES 2000
#endif

#if defined(__OPTIMIZE_SIZE__)
#elif defined(__ARM_ARCH_6M__)
#define RATES pel_cost_m0plus
#define SCENE_RATES pel_scene_cost_m0plus
#elif defined(__ARM_ARCH_7EM__)
#define RATES pel_cost_m4
#define SCENE_RATES pel_scene_cost_m4
#endif

#ifdef RATES

enum { WIDTH = 240, HEIGHT = 320, TEXELS = 64, MESH = 6, BINS = 400 };

static const struct pel_rect screen = {0, 0, WIDTH, HEIGHT};
static uint16_t pixels[WIDTH * HEIGHT], texels[TEXELS * TEXELS];
static struct pel_surface surface, picture;
static struct pel_texture texture;
static uint32_t state = 1;

/* How often a bound was so many percent of what is used; and the worst. */
static uint32_t bins[BINS], worst;

static int32_t below(int32_t limit)
{
    state = state * 1664525u + 1013904223u;
    return (int32_t)((state >> 8) % (uint32_t)limit);
}

static int32_t near_screen(int32_t size, int32_t side, int32_t out)
{
    return below(PEL_PX(pel_max(size - side, 0) + 2 * out) + 1) - PEL_PX(out);
}

/* In boxes of 4 to 256 px, half of them of small ones; one box in four may
 * leave the screen. */
static void make_triangle(struct pel_point v[3])
{
    const int32_t side = below(2) ? 4 << below(7) : 4 + below(253);
    const int32_t out = below(4) ? 0 : side;
    const int32_t x = near_screen(WIDTH, side, out);
    const int32_t y = near_screen(HEIGHT, side, out);
    for (int k = 0; k < 3; k++) {
        v[k].x = x + below(side * 256);
        v[k].y = y + below(side * 256);
    }
}

static void draw_triangle(enum pel_cost_paint kind, const struct pel_point v[3])
{
    static const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 128, 0));
    static const struct pel_flat alpha = PEL_FLAT(PEL_RGBA(255, 128, 0, 128));
    static const pel_color colors[3] = {
        PEL_RGB(250, 40, 20), PEL_RGB(20, 60, 240), PEL_RGB(40, 200, 90)};
    if (kind == PEL_COST_GOURAUD)
        pel_triangle_gouraud(&surface, v, colors);
    else
        pel_triangle(&surface, v,
                     kind == PEL_COST_FLAT    ? &flat.paint
                     : kind == PEL_COST_ALPHA ? &alpha.paint
                                              : &texture.base.paint);
}

/* All of the screen is inside the picture. */
static void make_texture(enum pel_cost_paint kind)
{
    static const struct pel_texels of_picture = {.surface = &picture};
    static const struct pel_texture_map map = {
        {UINT64_C(20) << 32, 640000000, 0 - UINT64_C(128000000)},
        {UINT64_C(2) << 32, 128000000, 640000000}};
    (kind == PEL_COST_NEAREST
         ? pel_texture_init_nearest
         : pel_texture_init_bilinear)(&texture, &of_picture, &map);
}

/* What the stopwatch can tell. */
static bool is_short(const struct pel_cost *cost)
{
    return cost->instructions < 10000000;
}

static void note(const struct pel_cost *cost, int32_t eighths)
{
    const uint32_t used = (uint32_t)eighths / 8 + 1;
    const uint32_t share = (uint32_t)(used * 100 / cost->instructions);
    const uint32_t bound = (uint32_t)(cost->instructions * 100 / used);
    worst = share > worst ? share : worst;
    bins[bound < BINS ? bound : BINS - 1]++;
}

static bool cost_report(const char *name)
{
    char line[40];
    uint32_t half = 0, count = 0, median = 0;
    for (int i = 0; i < BINS; i++)
        count += bins[i];
    for (; half < count / 2; median++)
        half += bins[median];
    snprintf(line, sizeof line, "cost-%s-used", name);
    report(line, COST_TRIANGLES, (int32_t)worst * 8, 1);
    snprintf(line, sizeof line, "cost-%s-median", name);
    report(line, COST_TRIANGLES, (int32_t)median * 8, 1);
    const bool holds = worst < 100;
    for (int i = 0; i < BINS; i++)
        bins[i] = 0;
    worst = 0;
    return holds;
}

static void check_triangles(enum pel_cost_paint kind)
{
    make_texture(kind);
    for (int i = 0; i < COST_TRIANGLES; i++) {
        struct pel_point v[3];
        struct pel_cost cost = {0};
        make_triangle(v);
        pel_triangle_cost(&cost, v, &surface.clip, &RATES[kind]);
        if (!is_short(&cost))
            continue;
        const uint32_t from = stopwatch_read();
        draw_triangle(kind, v);
        note(&cost, stopwatch_eighths(from, stopwatch_read()));
    }
}

static int16_t positions[3 * MESH][3];
static int8_t normals[3 * MESH][3];
static uint8_t indices[MESH][3];
static struct pel_mesh mesh = {.position = {{0, 0, 0}, 1, 9},
                               .positions = (void *)positions,
                               .normals8 = (void *)normals,
                               .indices8 = (void *)indices};

/* Up to six triangles, some of them around the near plane. */
static void make_mesh(bool cut)
{
    const int32_t side = below(2) ? 40 << below(5) : 40 + below(700);
    mesh.triangles = 1 + (uint32_t)below(MESH);
    mesh.vertices = 3 * mesh.triangles;
    for (uint32_t i = 0; i < mesh.triangles; i++) {
        const int32_t middle[3] = {below(700) - 350, below(900) - 450,
                                   cut ? 1300 : below(600) - 300};
        for (uint32_t k = 0; k < 9; k++) {
            const uint32_t v = 3 * i + k / 3;
            indices[i][k / 3] = (uint8_t)v;
            normals[v][k % 3] = (int8_t)(below(255) - 127);
            positions[v][k % 3] =
                (int16_t)(middle[k % 3] + below(side) - side / 2);
        }
    }
}

static void check_scenes(enum pel_scene_cost_kind kind)
{
    static const struct pel_shading *const shadings[PEL_SCENE_COSTS] = {
        &pel_shade_lit_flat, &pel_shade_lit_gouraud, &pel_shade_phong};
    static uint64_t scratch[400];
    static struct pel_frame frame;
    struct pel_scene scene = {.mesh = &mesh,
                              .camera = {.eye = {0, 0, PEL_UNITS(3)},
                                         .up = {0, 1, 0},
                                         .near_plane = PEL_UNITS(1) / 4,
                                         .focal = 50,
                                         .sensor = {30, 40}},
                              .viewport = screen,
                              .lighting = &lighting,
                              .color = PEL_RGB(200, 180, 90),
                              .shading = shadings[kind]};
    for (int i = 0; i < COST_TRIANGLES / 4; i++) {
        struct pel_surface band = surface;
        struct pel_cost cost = {0};
        make_mesh(i % 8 == 0);
        if (i % 3 == 0)
            band.clip.y1 = 20 + (band.clip.y0 = below(300));
        if (pel_scene_prepare(&frame, &scene, scratch, sizeof scratch) ||
            frame.triangles == 0)
            continue;
        pel_scene_cost(&cost, &frame, &band, &SCENE_RATES[kind]);
        if (!is_short(&cost))
            continue;
        const uint32_t from = stopwatch_read();
        pel_scene_draw(&frame, &band);
        note(&cost, stopwatch_eighths(from, stopwatch_read()));
    }
}

bool costs_report(void)
{
    static const char *const paints[PEL_COST_PAINTS] = {
        "flat", "alpha", "gouraud", "nearest", "bilinear"};
    static const char *const scenes[PEL_SCENE_COSTS] = {
        "mesh-flat", "mesh-gouraud", "mesh-phong"};
    bool holds = true;
    pel_surface_init(&surface, &pel_rgb565_le, pixels, sizeof pixels, &screen);
    pel_surface_init(&picture, &pel_rgb565_le, texels, sizeof texels,
                     &(struct pel_rect){0, 0, TEXELS, TEXELS});
    for (int k = 0; k < PEL_COST_PAINTS; k++) {
        check_triangles((enum pel_cost_paint)k);
        holds &= cost_report(paints[k]);
    }
    for (int k = 0; k < PEL_SCENE_COSTS; k++) {
        check_scenes((enum pel_scene_cost_kind)k);
        holds &= cost_report(scenes[k]);
    }
    return holds;
}

#else

bool costs_report(void)
{
    return true;
}

#endif
