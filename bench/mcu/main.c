/* Instructions per triangle, counted in an emulator in which time
 * is instructions. */
#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "core/pel.h"

enum { WIDTH = 240, HEIGHT = 320, TRIANGLES = 200 };

typedef void draw_function(const struct pel_surface *surface,
                           const struct pel_point v[3],
                           const struct pel_paint *paint);

static uint16_t pixels[WIDTH * HEIGHT];
static struct pel_point triangle[TRIANGLES][3];

static const struct pel_surface surface = {
    .pixels = pixels,
    .stride = WIDTH * 2,
    .bounds = {0, 0, WIDTH, HEIGHT},
    .clip = {0, 0, WIDTH, HEIGHT},
    .format = &pel_rgb565_le,
};

static int32_t random_below(uint32_t *state, int32_t limit)
{
    *state = *state * 1664525u + 1013904223u;
    return (int32_t)((*state >> 8) % (uint32_t)limit);
}

/* Triangles with three random vertices in a box of `side` px at a random
 * sub-pixel place on the screen. */
static void triangles_make(int32_t side)
{
    uint32_t state = 12345;
    for (int i = 0; i < TRIANGLES; i++) {
        int32_t x = random_below(&state, (WIDTH - side) * 256);
        int32_t y = random_below(&state, (HEIGHT - side) * 256);
        for (int k = 0; k < 3; k++) {
            triangle[i][k].x = x + random_below(&state, side * 256);
            triangle[i][k].y = y + random_below(&state, side * 256);
        }
    }
}

static int32_t triangles_time(draw_function *draw,
                              const struct pel_paint *paint)
{
    uint32_t from = stopwatch_read();
    for (int i = 0; i < TRIANGLES; i++)
        draw(&surface, triangle[i], paint);
    return stopwatch_eighths(from, stopwatch_read());
}

/* What the loop itself costs. */
static void draw_nothing(const struct pel_surface *s,
                         const struct pel_point v[3], const struct pel_paint *p)
{
    (void)s;
    (void)v;
    (void)p;
}

static void fill_nothing(const struct pel_paint *paint,
                         const struct pel_spans *rows)
{
    (void)paint;
    (void)rows;
}

static void triangles_report(const char *name, const struct pel_paint *paint)
{
    static const int32_t sides[] = {4, 16, 64, 220};
    draw_function *volatile loop_only = draw_nothing;
    for (unsigned i = 0; i < sizeof sides / sizeof *sides; i++) {
        triangles_make(sides[i]);
        int32_t loop = triangles_time(loop_only, paint);
        int32_t time = triangles_time(pel_triangle, paint);
        report(name, sides[i], time - loop, TRIANGLES);
    }
}

int main(void)
{
    static const struct pel_paint none = {.fill = fill_nothing};
    static const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 128, 0));
    stopwatch_start();
    triangles_report("walk", &none);
    triangles_report("fill", &flat.paint);
    textures_report();
    hits_report();
    matrix_report();
    fills_report();
    gradients_report();
    paths_report();
    smooth_report();
    return !shapes_report();
}
