/* Shapes with smooth edges: in one color, opaque and with alpha, in a gradient
 * and in a texture, on three formats; but in ring_window the clip has the whole
 * shape. */
#include <stdio.h>

#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "core/pel.h"

enum { WIDTH = 216, HEIGHT = 216 };

static uint32_t pixels[WIDTH * HEIGHT];
static struct pel_surface surface;

/* The centre of round shapes, whole pixels or not. */
static const struct pel_point whole = PEL_AT(70, 80);
static const struct pel_point any = {PEL_PX(70) + 37, PEL_PX(80) + 81};

static void triangle(const struct pel_paint *paint, int32_t side)
{
    const struct pel_point v[3] = {PEL_AT(50, 50), pel_at(50 + side, 61),
                                   pel_at(59, 50 + side)};
    pel_smooth_triangle(&surface, v, paint);
}

static void needle(const struct pel_paint *paint, int32_t length)
{
    const struct pel_point v[3] = {pel_at(57, 20 + length), PEL_AT(61, 20),
                                   pel_at(64, 20 + length)};
    pel_smooth_triangle(&surface, v, paint);
}

/* Along a diagonal; its length is that along an axis. */
static void needle_turned(const struct pel_paint *paint, int32_t length)
{
    const struct pel_point v[3] = {{PEL_PX(60), PEL_PX(40) - 700},
                                   pel_at(60 + length, 40 + length),
                                   {PEL_PX(60) - 700, PEL_PX(40)}};
    pel_smooth_triangle(&surface, v, paint);
}

static PEL_ALWAYS_INLINE struct pel_thick_line_shape line_of(int32_t length)
{
    return (struct pel_thick_line_shape){{PEL_PX(50) + 30, PEL_PX(50) + 70},
                                         pel_at(50 + length, 50 + length / 2),
                                         PEL_PX(2)};
}

static void line(const struct pel_paint *paint, int32_t length)
{
    const struct pel_thick_line_shape shape = line_of(length);
    pel_smooth_thick_line(&surface, &shape, paint);
}

static void line_round(const struct pel_paint *paint, int32_t length)
{
    const struct pel_thick_line_shape shape = line_of(length);
    pel_smooth_thick_line_round(&surface, &shape, paint);
}

/* Of five corners, its lines cross. */
static void star(const struct pel_paint *paint, int32_t radius)
{
    static uint64_t scratch[PEL_SMOOTH_POLYGON_SCRATCH_SIZE(5, WIDTH) / 8 + 1];
    struct pel_point v[5];
    const struct pel_polygon_shape shape = {v, 5, PEL_NON_ZERO};
    for (int i = 0; i < 5; i++) {
        const struct pel_point d = pel_direction((uint16_t)(i * 26214));
        v[i].x = any.x + radius * d.x / 128;
        v[i].y = any.y + radius * d.y / 128;
    }
    pel_smooth_polygon(&surface, &shape, paint, scratch, sizeof scratch);
}

static void rectangle(const struct pel_paint *paint, int32_t side)
{
    const struct pel_point from = {PEL_PX(9) + 77, PEL_PX(9) + 99};
    const struct pel_point to = {from.x + PEL_PX(side), from.y + PEL_PX(side)};
    pel_smooth_rectangle(&surface, from, to, paint);
}

static void circle(const struct pel_paint *paint, int32_t radius)
{
    pel_smooth_circle(&surface, any, PEL_PX(radius), paint);
}

static void circle_whole(const struct pel_paint *paint, int32_t radius)
{
    pel_smooth_circle(&surface, whole, PEL_PX(radius), paint);
}

static void ring(const struct pel_paint *paint, int32_t radius)
{
    const struct pel_ring_shape shape = {any, PEL_PX(radius - 4),
                                         PEL_PX(radius)};
    pel_smooth_ring(&surface, &shape, paint);
}

static void ring_whole(const struct pel_paint *paint, int32_t radius)
{
    const struct pel_ring_shape shape = {whole, PEL_PX(radius - 4),
                                         PEL_PX(radius)};
    pel_smooth_ring(&surface, &shape, paint);
}

/* What a dirty window shows of one. */
static void ring_window(const struct pel_paint *paint, int32_t radius)
{
    pel_surface_clip(&surface, &(struct pel_rect){90, 30, 140, 70});
    ring_whole(paint, radius);
    pel_surface_clip(&surface, &surface.bounds);
}

/* Three quarters of a gauge of 12 px, its centre on whole pixels. */
static void arc_round(const struct pel_paint *paint, int32_t radius)
{
    const struct pel_arc_shape shape = {PEL_AT(108, 108), PEL_PX(radius - 12),
                                        PEL_PX(radius), 24576, 73728};
    pel_smooth_arc_round(&surface, &shape, paint);
}

static void sector(const struct pel_paint *paint, int32_t radius)
{
    const struct pel_sector_shape shape = {any, PEL_PX(radius), 5000, 30000};
    pel_smooth_sector(&surface, &shape, paint);
}

static void ellipse(const struct pel_paint *paint, int32_t radius)
{
    const struct pel_ellipse_shape shape = {
        any, {PEL_PX(radius), PEL_PX(radius) * 3 / 5}};
    pel_smooth_ellipse(&surface, &shape, paint);
}

/* 100 x 60 px. */
static void rounded_rectangle(const struct pel_paint *paint, int32_t radius)
{
    const struct pel_rounded_shape shape = {PEL_AT(20, 30), PEL_AT(120, 90),
                                            PEL_PX(radius)};
    pel_smooth_rounded_rectangle(&surface, &shape, paint);
}

static const struct {
    const char *name;
    void (*draw)(const struct pel_paint *paint, int32_t parameter);
    int32_t parameter; /* px */
    bool in_matrix;    /* with every paint and format */
} cases[] = {
    {"triangle", triangle, 16, false},
    {"triangle", triangle, 64, true},
    {"needle", needle, 100, true},
    {"needle_turned", needle_turned, 70, false},
    {"line", line, 100, false},
    {"line_round", line_round, 100, true},
    {"star", star, 50, true},
    {"rectangle", rectangle, 50, false},
    {"circle", circle, 10, false},
    {"circle", circle, 50, true},
    {"circle_whole", circle_whole, 10, false},
    {"circle_whole", circle_whole, 50, true},
    {"ring", ring, 50, false},
    {"ring_whole", ring_whole, 50, true},
    {"ring_window", ring_window, 50, false},
    {"arc_round", arc_round, 100, true},
    {"sector", sector, 50, false},
    {"ellipse", ellipse, 50, false},
    {"rounded_rectangle", rounded_rectangle, 12, true},
};

static void case_report(int i, const char *kind, const struct pel_paint *paint)
{
    char name[48];
    snprintf(name, sizeof name, "smooth-%s-%s", cases[i].name, kind);
    const uint32_t from = stopwatch_read();
    cases[i].draw(paint, cases[i].parameter);
    report(name, cases[i].parameter, stopwatch_eighths(from, stopwatch_read()),
           1);
}

/* From corner to corner, and a picture of its own size. */
static struct pel_linear linear;
static struct pel_texture texture;

static void paints_init(const struct pel_format *format)
{
    static const pel_color ends[2] = {PEL_RGB(255, 200, 0), PEL_RGB(0, 60, 90)};
    static const struct pel_texture_map map = PEL_TEXTURE_AT(0, 0);
    static uint32_t picture[64 * 64];
    static struct pel_surface source;
    const struct pel_texels texels = {&source, NULL, 0, 0, true};
    const struct pel_ramp ramp = {ends, 2, PEL_PAD};
    for (uint32_t i = 0; i < 64 * 64; i++)
        picture[i] = i * 2654435761u;
    pel_surface_init(&source, format, picture, sizeof picture,
                     &(struct pel_rect){0, 0, 64, 64});
    pel_linear_init(&linear, (struct pel_point)PEL_AT(0, 0),
                    (struct pel_point)PEL_AT(WIDTH, HEIGHT), &ramp);
    pel_texture_init_nearest(&texture, &texels, &map);
    texture.wrap_u = texture.wrap_v = PEL_WRAP_REPEAT;
}

void smooth_report(void)
{
    static const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 128, 0));
    static const struct pel_flat alpha = PEL_FLAT(PEL_RGBA(255, 128, 0, 128));
    static const struct {
        const char *name;
        const struct pel_format *format;
    } formats[] = {{"", &pel_rgb565_le},
                   {"-xrgb8888", &pel_xrgb8888},
                   {"-gray4", &pel_gray4}};
    static const struct {
        const char *name;
        const struct pel_paint *paint;
    } paints[] = {{"flat", &flat.paint},
                  {"alpha", &alpha.paint},
                  {"linear", &linear.base.paint},
                  {"texture", &texture.base.paint}};
    const struct pel_rect bounds = {0, 0, WIDTH, HEIGHT};
    char kind[24];
    for (int f = 0; f < 3; f++) {
        pel_surface_init(&surface, formats[f].format, pixels, sizeof pixels,
                         &bounds);
        paints_init(formats[f].format);
        for (int i = 0; i < (int)(sizeof cases / sizeof *cases); i++)
            for (int k = 0; k < 4; k++) {
                if (!cases[i].in_matrix && (f > 0 || k > 1))
                    continue;
                snprintf(kind, sizeof kind, "%s%s", paints[k].name,
                         formats[f].name);
                case_report(i, kind, paints[k].paint);
            }
    }
}
