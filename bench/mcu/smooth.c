/* Shapes with smooth edges on RGB565, in one color, opaque and with alpha;
 * but in ring_window the clip has the whole shape. */
#include <stdio.h>

#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "core/pel.h"

enum { WIDTH = 216, HEIGHT = 216 };

static uint16_t pixels[WIDTH * HEIGHT];
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

static void line(const struct pel_paint *paint, int32_t length)
{
    const struct pel_thick_line_shape shape = {
        {PEL_PX(50) + 30, PEL_PX(50) + 70},
        pel_at(50 + length, 50 + length / 2),
        PEL_PX(2)};
    pel_smooth_thick_line(&surface, &shape, paint);
}

static void line_round(const struct pel_paint *paint, int32_t length)
{
    const struct pel_thick_line_shape shape = {
        {PEL_PX(50) + 30, PEL_PX(50) + 70},
        pel_at(50 + length, 50 + length / 2),
        PEL_PX(2)};
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
} cases[] = {
    {"triangle", triangle, 16},
    {"triangle", triangle, 64},
    {"needle", needle, 100},
    {"needle_turned", needle_turned, 70},
    {"line", line, 100},
    {"line_round", line_round, 100},
    {"star", star, 50},
    {"rectangle", rectangle, 50},
    {"circle", circle, 10},
    {"circle", circle, 50},
    {"circle_whole", circle_whole, 10},
    {"circle_whole", circle_whole, 50},
    {"ring", ring, 50},
    {"ring_whole", ring_whole, 50},
    {"ring_window", ring_window, 50},
    {"arc_round", arc_round, 100},
    {"sector", sector, 50},
    {"ellipse", ellipse, 50},
    {"rounded_rectangle", rounded_rectangle, 12},
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

void smooth_report(void)
{
    static const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 128, 0));
    static const struct pel_flat alpha = PEL_FLAT(PEL_RGBA(255, 128, 0, 128));
    const struct pel_rect bounds = {0, 0, WIDTH, HEIGHT};
    pel_surface_init(&surface, &pel_rgb565_le, pixels, sizeof pixels, &bounds);
    for (int i = 0; i < (int)(sizeof cases / sizeof *cases); i++) {
        case_report(i, "flat", &flat.paint);
        case_report(i, "alpha", &alpha.paint);
    }
}
