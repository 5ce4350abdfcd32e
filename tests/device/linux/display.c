/* The seam of displays and its example, display_memory: bands of memory of the
 * program's own, the defaults, and pictures in other formats. */
#include <stdio.h>
#include <string.h>

#include "core/pel.h"
#include "drivers/display_memory.h"

enum { WIDTH = 53, HEIGHT = 41, BYTES = 4 * WIDTH * HEIGHT };

static int failures;

static void expect(int right, const char *what)
{
    if (!right) {
        printf("FAIL display: %s\n", what);
        failures++;
    }
}

static void draw(const struct pel_surface *surface)
{
    static const struct pel_point corners[3] = {PEL_AT(3, 2), PEL_AT(50, 11),
                                                PEL_AT(20, 39)};
    static const pel_color colors[3] = {PEL_RGB(255, 0, 0), PEL_RGB(0, 255, 9),
                                        PEL_RGB(9, 8, 255)};
    pel_clear(surface, PEL_RGB(40, 50, 60));
    pel_triangle_gouraud(surface, corners, colors);
}

/* Draws bands of `rows` lines in memory of its own and flushes each. */
static void show_in_bands(const struct pel_display *display,
                          const struct pel_format *format, int32_t rows)
{
    static uint32_t band[WIDTH * HEIGHT];
    for (int32_t y = 0; y < display->height; y += rows) {
        struct pel_rect area = {0, y, display->width,
                                pel_min(y + rows, display->height)};
        struct pel_surface surface;
        enum pel_status status = pel_surface_init_rect(
            &surface, format, band, pel_stride(format, display->width), &area);
        memset(band, 0x5A, sizeof(band));
        expect(status == PEL_OK, "a band is a surface");
        status = pel_display_begin(display, &area, &surface);
        expect(status == PEL_OK, "begin with memory of the program's own");
        draw(&surface);
        expect(pel_display_flush(display, &surface) == PEL_OK, "flush");
        expect(pel_display_wait(display) == PEL_OK, "wait has a default");
    }
    expect(pel_display_flip(display) == PEL_OK, "flip has a default");
}

static void check_bands(const struct pel_format *format)
{
    static uint32_t whole_pixels[WIDTH * HEIGHT], shown_pixels[WIDTH * HEIGHT];
    struct pel_surface whole;
    struct pel_display_memory memory;
    struct pel_display display;
    memset(whole_pixels, 0, sizeof(whole_pixels));
    pel_surface_init(&whole, format, whole_pixels, sizeof whole_pixels,
                     &(struct pel_rect){0, 0, WIDTH, HEIGHT});
    draw(&whole);
    for (int32_t rows = 8; rows <= 48; rows += 8) {
        memset(shown_pixels, 0, sizeof(shown_pixels));
        pel_surface_init(&memory.screen, format, shown_pixels,
                         sizeof shown_pixels,
                         &(struct pel_rect){0, 0, WIDTH, HEIGHT});
        expect(pel_display_memory_init(&display, &memory) == PEL_OK, "init");
        show_in_bands(&display, format, rows);
        expect(memcmp(whole_pixels, shown_pixels, BYTES) == 0,
               "bands equal the whole");
    }
}

/* Opaque pictures in 24 bits, shown in fewer, are those drawn in fewer. */
static void check_conversion(void)
{
    static uint32_t whole_pixels[WIDTH * HEIGHT], shown_pixels[WIDTH * HEIGHT];
    struct pel_surface whole;
    struct pel_display_memory memory;
    struct pel_display display;
    pel_surface_init(&whole, &pel_rgb565_be, whole_pixels, sizeof whole_pixels,
                     &(struct pel_rect){0, 0, WIDTH, HEIGHT});
    draw(&whole);
    pel_surface_init(&memory.screen, &pel_rgb565_be, shown_pixels,
                     sizeof shown_pixels,
                     &(struct pel_rect){0, 0, WIDTH, HEIGHT});
    pel_display_memory_init(&display, &memory);
    show_in_bands(&display, &pel_xrgb8888, 7);
    expect(memcmp(whole_pixels, shown_pixels, WIDTH * HEIGHT * 2) == 0,
           "another format is converted");
}

static void check_errors(void)
{
    static uint32_t pixels[WIDTH * HEIGHT];
    struct pel_surface small;
    struct pel_display_memory memory;
    struct pel_display display;
    struct pel_rect area = {0, 0, WIDTH, HEIGHT}, grown = area;
    pel_surface_init(&memory.screen, &pel_xrgb8888, pixels, sizeof pixels,
                     &(struct pel_rect){0, 0, WIDTH, HEIGHT});
    expect(pel_display_memory_init(NULL, &memory) == PEL_ERROR_NULL, "NULL");
    memory.screen.bounds.x0 = 1;
    expect(pel_display_memory_init(&display, &memory) == PEL_ERROR_SIZE,
           "a screen begins at 0, 0");
    memory.screen.bounds.x0 = 0;
    expect(pel_display_memory_init(&display, &memory) == PEL_OK, "init");
    pel_surface_init(&small, &pel_xrgb8888, pixels, sizeof pixels,
                     &(struct pel_rect){0, 0, WIDTH, HEIGHT - 1});
    expect(pel_display_begin(&display, &area, &small) == PEL_ERROR_SIZE,
           "memory that does not hold the area");
    pel_display_align(&display, &grown);
    expect(memcmp(&grown, &area, sizeof(area)) == 0, "round has a default");
    small.clip.x1 = 0;
    expect(pel_display_flush(&display, &small) == PEL_OK, "nothing to flush");
}

int main(void)
{
    check_bands(&pel_xrgb8888);
    check_bands(&pel_rgb888);
    check_bands(&pel_rgb565_le);
    check_bands(&pel_gray4);
    check_bands(&pel_mono1);
    check_conversion();
    check_errors();
    if (!failures)
        printf("display: bands, conversions and defaults right\n");
    return failures != 0;
}
