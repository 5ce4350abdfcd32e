/* A trace on a screen of 320 x 240 px, drawn in bands of 20 lines: a sine of
 * 100 px and noise of 4, 320 points, 2 px wide with round joins; in 4 KB of
 * scratch memory, as smooth in 16. */
#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "core/pel.h"

enum { WIDTH = 320, HEIGHT = 240, ROWS = 20, POINTS = 320 };

static uint16_t band[WIDTH * ROWS];
static struct pel_point trace[POINTS];
static uint64_t scratch[16384 / 8];
static const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 214, 64));

typedef enum pel_status draw_function(const struct pel_surface *surface,
                                      const struct pel_polyline_shape *line,
                                      const struct pel_paint *paint,
                                      void *memory, size_t size);

static void make_trace(void)
{
    uint32_t noise = 1;
    for (int32_t i = 0; i < POINTS; i++) {
        noise = noise * 1664525 + 1013904223;
        trace[i].x = PEL_PX(i);
        trace[i].y = PEL_PX(HEIGHT / 2) +
                     pel_direction((uint16_t)(i * 410)).y * 100 / 128 / 2 +
                     (int32_t)(noise >> 22) - 512;
    }
}

/* The time of a picture; -1: no room in the scratch memory. */
static int32_t time_of(draw_function *draw, size_t size)
{
    static const struct pel_polyline_shape line = {
        .v = trace,
        .n = POINTS,
        .stroke = {
            .width = PEL_PX(2), .cap = PEL_CAP_ROUND, .join = PEL_JOIN_ROUND}};
    int32_t time = 0;
    for (int32_t y = 0; y < HEIGHT; y += ROWS) {
        struct pel_surface surface;
        const struct pel_rect rows = {0, y, WIDTH, y + ROWS};
        pel_surface_init(&surface, &pel_rgb565_le, band, sizeof band, &rows);
        const uint32_t from = stopwatch_read();
        if (draw(&surface, &line, &flat.paint, scratch, size))
            return -1;
        time += stopwatch_eighths(from, stopwatch_read());
    }
    return time;
}

void paths_report(void)
{
    make_trace();
    report("trace", POINTS, time_of(pel_polyline, 4096), 1);
    report("trace-smooth", POINTS, time_of(pel_smooth_polyline, sizeof scratch),
           1);
}
