/* What a pixel costs in every paint, copy and shading on four formats: rows of
 * 192 px less rows of 64, in a band of a screen of 240 x 320; and, on rgb565,
 * what setting up and drawing 8 x 8 px costs. */
#include <stdio.h>

#include "bench/letters.h"
#include "bench/lighting.h"
#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "core/format/argb8888.h"
#include "core/pel.h"

enum {
    LEFT = 24,
    TOP = 120,
    LONG = 192,
    SHORT = 64,
    ROWS = 8,
    SMALL = 8, /* px a side */
    SIDE = 256 /* of the picture, texels */
};

static uint32_t band_memory[LONG * ROWS], picture_memory[SIDE * SIDE];
static struct pel_surface band, picture, sprite;

static const struct pel_point corners[4] = {PEL_AT(0, 0), PEL_AT(240, 0),
                                            PEL_AT(240, 320), PEL_AT(0, 320)};
static const struct pel_point around[3] = {PEL_AT(-300, -10), PEL_AT(540, -10),
                                           PEL_AT(120, 700)};
static const pel_color colors[4] = {PEL_RGB(250, 40, 20), PEL_RGB(20, 60, 240),
                                    PEL_RGB(40, 200, 90),
                                    PEL_RGB(230, 220, 40)};
static const struct pel_ramp ramp = {colors, 2, PEL_PAD};

static union {
    struct pel_paint paint; /* the first member of all */
    struct pel_flat flat;
    struct pel_linear linear;
    struct pel_radial radial;
    struct pel_conic conic;
    struct pel_hue_wheel hue;
    struct pel_fan fan;
    struct pel_gouraud gouraud;
    struct pel_texture texture;
    struct pel_checker checker;
    struct pel_hatch hatch;
    struct pel_nine_slice slices;
} source;
static struct pel_dither dither;
static struct pel_blend blend;
static const struct pel_paint *paint;

/* A mesh of one triangle, larger than the screen, under one light. */
static const int16_t positions[3][3] = {
    {-900, -700, 0}, {900, -700, 0}, {0, 900, 0}};
static const int8_t normals[3][3] = {
    {-60, -60, 94}, {60, -60, 94}, {0, 85, 94}};
static const uint8_t indices[1][3] = {{0, 1, 2}};
static const struct pel_mesh mesh = {.vertices = 3,
                                     .triangles = 1,
                                     .position = {{0, 0, 0}, 1, 8},
                                     .positions = positions,
                                     .normals8 = normals,
                                     .indices8 = indices};
static struct pel_scene scene = {.mesh = &mesh,
                                 .camera = {.eye = {0, 0, PEL_UNITS(3)},
                                            .up = {0, 1, 0},
                                            .near_plane = PEL_UNITS(1) / 16,
                                            .focal = 50,
                                            .sensor = {30, 40}},
                                 .viewport = {0, 0, 240, 320},
                                 .lighting = &lighting,
                                 .color = PEL_RGB(200, 180, 90)};
static struct pel_frame frame;

static enum pel_status make_mesh(const struct pel_shading *shading)
{
    static uint64_t scratch[PEL_SCENE_SCRATCH_SIZE(4, 2, 1) / 8 + 1];
    scene.shading = shading;
    return pel_scene_prepare(&frame, &scene, scratch, sizeof scratch);
}

/* A step of 0.95 texels to the right and 0.24 down for a pixel to the right. */
static const struct pel_texels texels = {.surface = &picture};
static const struct pel_texture_map turned = {
    {UINT64_C(20) << 32, 4080218931, 0 - UINT64_C(1030792151)},
    {UINT64_C(20) << 32, 1030792151, 4080218931}};

enum make {
    FLAT,
    ALPHA,
    VERTICAL,
    HORIZONTAL,
    SLOPED,
    RADIAL,
    CONIC,
    HUE,
    FAN,
    GOURAUD,
    NEAREST,
    BILINEAR,
    CHECKER,
    HATCH,
    SLICES,
    MESH_FLAT,
    MESH_GOURAUD,
    MESH_PHONG
};

static enum pel_status make_source(enum make what)
{
    static const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 128, 0));
    static const struct pel_flat alpha = PEL_FLAT(PEL_RGBA(255, 128, 0, 128));
    static const struct pel_rings rings = {PEL_AT(120, 160), PEL_PX(200), 0};
    static struct pel_fan_triangle triangles[4];
    static const struct pel_fan_points fan = {
        PEL_AT(120, 160), PEL_RGB(255, 255, 255), corners, colors, 4};
    static const struct pel_checker_fields fields = {12, 12, 0, 0};
    static const struct pel_hatch_lines lines = {1, 1, 0, 9, 3};
    static const struct pel_rect middle = {8, 8, 16, 16},
                                 screen = {0, 0, 240, 320};
    switch (what) {
    case FLAT:
        source.flat = flat;
        return PEL_OK;
    case ALPHA:
        source.flat = alpha;
        return PEL_OK;
    case VERTICAL:
        return pel_linear_init(&source.linear, corners[0], corners[3], &ramp);
    case HORIZONTAL:
        return pel_linear_init(&source.linear, corners[0], corners[1], &ramp);
    case SLOPED:
        return pel_linear_init(&source.linear, corners[0], corners[2], &ramp);
    case RADIAL:
        return pel_radial_init(&source.radial, &rings, &ramp);
    case CONIC:
        return pel_conic_init(&source.conic, rings.center, 0, &ramp);
    case HUE:
        return pel_hue_wheel_init(&source.hue, rings.center, 0, 255, 255);
    case FAN:
        return pel_fan_init(&source.fan, &fan, triangles);
    case GOURAUD:
        return pel_gouraud_init(&source.gouraud, around, colors);
    case NEAREST:
        return pel_texture_init_nearest(&source.texture, &texels, &turned);
    case BILINEAR:
        return pel_texture_init_bilinear(&source.texture, &texels, &turned);
    case CHECKER:
        return pel_checker_init(&source.checker, &fields, colors[0], colors[1]);
    case HATCH:
        return pel_hatch_init(&source.hatch, &lines, colors[0], colors[1]);
    case SLICES:
        return pel_nine_slice_init(&source.slices, &picture, &middle, &screen);
    case MESH_FLAT:
        return make_mesh(&pel_shade_lit_flat);
    case MESH_GOURAUD:
        return make_mesh(&pel_shade_lit_gouraud);
    case MESH_PHONG:
        return make_mesh(&pel_shade_phong);
    }
    return PEL_ERROR_RANGE;
}

static void draw_paint(int32_t width, int32_t rows)
{
    const struct pel_point from = PEL_AT(LEFT, TOP);
    const struct pel_point to = PEL_AT(LEFT + width, TOP + rows);
    pel_rectangle(&band, from, to, paint);
}

static void draw_copy(int32_t width, int32_t rows)
{
    pel_copy(&band,
             &(struct pel_copy_part){&picture, {0, 0, width, rows}, LEFT, TOP});
}

static void draw_keyed(int32_t width, int32_t rows)
{
    pel_copy_keyed(
        &band,
        &(struct pel_copy_part){&picture, {0, 0, width, rows}, LEFT, TOP},
        PEL_RGB(0, 0, 0));
}

static void draw_copy_alpha(int32_t width, int32_t rows)
{
    pel_copy_alpha(
        &band, &(struct pel_copy_part){&sprite, {0, 0, width, rows}, LEFT, TOP},
        255);
}

/* Eight rows of runs of 12 words and 4 as they are. */
static uint32_t run_words[7 * LONG / 16];
static const uint16_t run_rows[ROWS] = {0};
static struct pel_runs_asset runs = {PEL_RUNS_MAGIC,     PEL_RUNS_VERSION,
                                     .width = LONG,      .height = ROWS,
                                     .words = run_words, .rows16 = run_rows};

static void make_runs(const struct pel_format *format)
{
    const uint32_t bytes = format->bits < 8 ? 1 : format->bits / 8u;
    uint8_t *const words = (uint8_t *)run_words;
    runs.format = format->id;
    runs.size = 7 * LONG / 16;
    for (uint32_t i = 0; i < runs.size * bytes; i++)
        words[i] = (uint8_t)(i * 2654435761u >> 24);
    for (uint32_t i = 0; i < runs.size; i += 7)
        for (uint32_t k = 0; k < bytes; k++) {
            words[i * bytes + k] = k ? 0 : 2 * 12 + 1;
            words[(i + 2) * bytes + k] = k ? 0 : 2 * 4;
        }
}

static void draw_runs(int32_t width, int32_t rows)
{
    const struct pel_runs_part part = {&runs, band.format, LEFT, TOP};
    runs.width = (uint16_t)width;
    runs.height = (uint16_t)rows;
    pel_copy_runs(&band, &part, 255);
}

/* Letters of 8 x 8 px, in one color. */
static void draw_text(int32_t width, int32_t rows)
{
    (void)rows;
    pel_text(&band,
             &(struct pel_text_block){
                 &letters, letters_line + (LONG - width) / 8, LEFT, TOP},
             paint);
}

static void draw_mesh(int32_t width, int32_t rows)
{
    struct pel_surface part = band;
    pel_surface_clip(&part,
                     &(struct pel_rect){LEFT, TOP, LEFT + width, TOP + rows});
    pel_scene_draw(&frame, &part);
}

static const struct {
    const char *name;
    enum make make;
    void (*draw)(int32_t width, int32_t rows);
    enum { PLAIN, DITHERED, XORED } around;
} cases[] = {
    {"flat", FLAT, draw_paint, PLAIN},
    {"alpha", ALPHA, draw_paint, PLAIN},
    {"linear-vertical", VERTICAL, draw_paint, PLAIN},
    {"linear-horizontal", HORIZONTAL, draw_paint, PLAIN},
    {"linear-sloped", SLOPED, draw_paint, PLAIN},
    {"radial", RADIAL, draw_paint, PLAIN},
    {"conic", CONIC, draw_paint, PLAIN},
    {"hue", HUE, draw_paint, PLAIN},
    {"fan", FAN, draw_paint, PLAIN},
    {"gouraud", GOURAUD, draw_paint, PLAIN},
    {"nearest", NEAREST, draw_paint, PLAIN},
    {"bilinear", BILINEAR, draw_paint, PLAIN},
    {"checker", CHECKER, draw_paint, PLAIN},
    {"hatch", HATCH, draw_paint, PLAIN},
    {"nine-slice", SLICES, draw_paint, PLAIN},
    {"xor-flat", FLAT, draw_paint, XORED},
    {"dithered-flat", FLAT, draw_paint, DITHERED},
    {"dithered-linear", SLOPED, draw_paint, DITHERED},
    {"dithered-gouraud", GOURAUD, draw_paint, DITHERED},
    {"dithered-nearest", NEAREST, draw_paint, DITHERED},
    {"copy", FLAT, draw_copy, PLAIN},
    {"copy-keyed", FLAT, draw_keyed, PLAIN},
    {"copy-alpha", FLAT, draw_copy_alpha, PLAIN},
    {"copy-runs", FLAT, draw_runs, PLAIN},
    {"text", FLAT, draw_text, PLAIN},
    {"mesh-flat", MESH_FLAT, draw_mesh, PLAIN},
    {"mesh-gouraud", MESH_GOURAUD, draw_mesh, PLAIN},
    {"mesh-phong", MESH_PHONG, draw_mesh, PLAIN},
};

static int32_t draw_time(int i, int32_t width, int32_t rows)
{
    const uint32_t from = stopwatch_read();
    cases[i].draw(width, rows);
    return stopwatch_eighths(from, stopwatch_read());
}

static void make(int i)
{
    if (make_source(cases[i].make) != PEL_OK)
        printf("%s refused\n", cases[i].name);
    pel_dither_init(&dither, &source.paint);
    pel_blend_init(&blend, &source.paint, PEL_BLEND_XOR);
    paint = cases[i].around == DITHERED ? &dither.paint
            : cases[i].around == XORED  ? &blend.paint
                                        : &source.paint;
}

static void case_report(int i, const char *format)
{
    char name[40];
    snprintf(name, sizeof name, "%s/%s", format, cases[i].name);
    const uint32_t from = stopwatch_read();
    make(i);
    const int32_t init = stopwatch_eighths(from, stopwatch_read());
    report(name, LONG - SHORT,
           draw_time(i, LONG, ROWS) - draw_time(i, SHORT, ROWS),
           (LONG - SHORT) * ROWS);
    if (band.format == &pel_rgb565_le)
        report(name, SMALL, init + draw_time(i, SMALL, SMALL), 1);
}

/* The picture has stripes of noise and of zeros, 16 bytes each: what a key
 * leaves out, and transparent in the sprite, which is the same memory. */
static void format_begin(const struct pel_format *format)
{
    const struct pel_rect bounds = {LEFT, TOP, LEFT + LONG, TOP + ROWS};
    const struct pel_rect square = {0, 0, SIDE, SIDE};
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        picture_memory[i] = i / 4 & 1 ? i * 2654435761u : 0;
    pel_surface_init_rect(&band, format, band_memory, pel_stride(format, LONG),
                          &bounds);
    pel_surface_init(&picture, format, picture_memory, sizeof picture_memory,
                     &square);
    pel_surface_init(&sprite, &pel_argb8888, picture_memory,
                     sizeof picture_memory, &square);
    make_runs(format);
}

void matrix_report(void)
{
    static const struct {
        const char *name;
        const struct pel_format *format;
    } formats[] = {{"rgb565", &pel_rgb565_le},
                   {"xrgb8888", &pel_xrgb8888},
                   {"gray8", &pel_gray8},
                   {"mono1", &pel_mono1}};
    for (unsigned k = 0; k < sizeof formats / sizeof *formats; k++) {
        format_begin(formats[k].format);
        for (int i = 0; i < (int)(sizeof cases / sizeof *cases); i++)
            case_report(i, formats[k].name);
    }
}
