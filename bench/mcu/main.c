/* Instructions per triangle and per pixel, counted in an emulator in which time
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

static int32_t rectangle_time(int32_t width, const struct pel_paint *paint)
{
    const struct pel_point top_left = PEL_AT(10, 10);
    const struct pel_point bottom_right = PEL_AT(10 + width, HEIGHT - 10);
    uint32_t from = stopwatch_read();
    pel_rectangle(&surface, top_left, bottom_right, paint);
    return stopwatch_eighths(from, stopwatch_read());
}

/* The cost of a pixel more in a long run: rows of 208 px less rows of 16. */
static void pixels_report(const char *name, const struct pel_paint *paint)
{
    const int32_t wide = 208, narrow = 16;
    int32_t time = rectangle_time(wide, paint) - rectangle_time(narrow, paint);
    report(name, wide - narrow, time,
           (uint32_t)(wide - narrow) * (HEIGHT - 20));
}

int main(void)
{
    static const struct pel_paint none = {.fill = fill_nothing};
    static const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 128, 0));
    static const struct pel_flat glass = PEL_FLAT(PEL_RGBA(255, 128, 0, 100));
    static const struct pel_point screen[3] = {
        PEL_AT(-300, -10), PEL_AT(540, -10), PEL_AT(120, 700)};
    static const pel_color colors[3] = {PEL_RGB(255, 0, 0), PEL_RGB(0, 255, 0),
                                        PEL_RGB(0, 0, 255)};
    struct pel_gouraud gouraud;
    pel_gouraud_init(&gouraud, screen, colors);
    stopwatch_start();
    triangles_report("walk", &none);
    triangles_report("fill", &flat.paint);
    pixels_report("flat-pixel", &flat.paint);
    pixels_report("alpha-pixel", &glass.paint);
    pixels_report("gouraud-pixel", &gouraud.paint);
    textures_report();
    hits_report();
    matrix_report();
    return 0;
}
