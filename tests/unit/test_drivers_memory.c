/* The display in memory: bands of the program's own memory, the defaults of
 * displays, and pictures in other formats. */
#include <string.h>

#include "drivers/display_memory.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"

enum { WIDTH = 53, HEIGHT = 41 };

static uint32_t whole_pixels[WIDTH * HEIGHT], shown_pixels[WIDTH * HEIGHT];
static const struct pel_rect area = {0, 0, WIDTH, HEIGHT};

static void draw(const struct pel_surface *surface)
{
    static const struct pel_point corners[3] = {PEL_AT(3, 2), PEL_AT(50, 11),
                                                PEL_AT(20, 39)};
    static const pel_color colors[3] = {PEL_RGB(255, 0, 0), PEL_RGB(0, 255, 9),
                                        PEL_RGB(9, 8, 255)};
    pel_clear(surface, PEL_RGB(40, 50, 60));
    pel_triangle_gouraud(surface, corners, colors);
}

/* Bands of `rows` lines in `format`, flushed one by one, make a screen in
 * another format, or the same, the picture that is drawn there. */
static void check_bands(const struct pel_format *screen,
                        const struct pel_format *format, int32_t rows)
{
    static uint32_t band[WIDTH * HEIGHT];
    struct pel_display_memory memory;
    struct pel_display display;
    memset(whole_pixels, 0, sizeof whole_pixels);
    memset(shown_pixels, 0, sizeof shown_pixels);
    const struct pel_surface whole =
        surface_of(screen, whole_pixels, sizeof whole_pixels, WIDTH, HEIGHT);
    memory.screen =
        surface_of(screen, shown_pixels, sizeof shown_pixels, WIDTH, HEIGHT);
    draw(&whole);
    assert_int_equal(pel_display_memory_init(&display, &memory), PEL_OK);
    for (int32_t y = 0; y < HEIGHT; y += rows) {
        const struct pel_rect part = {0, y, WIDTH, pel_min(y + rows, HEIGHT)};
        struct pel_surface s;
        memset(band, 0x5A, sizeof band);
        assert_int_equal(pel_surface_init(&s, format, band, sizeof band, &part),
                         PEL_OK);
        assert_int_equal(pel_display_begin(&display, &part, &s), PEL_OK);
        draw(&s);
        assert_int_equal(pel_display_flush(&display, &s), PEL_OK);
        assert_int_equal(pel_display_wait(&display), PEL_OK);
    }
    assert_int_equal(pel_display_flip(&display), PEL_OK);
    assert_memory_equal(whole_pixels, shown_pixels, sizeof whole_pixels);
}

TEST(bands)
{
    for (int i = 0; i < LAYOUT_COUNT; i++)
        for (int32_t rows = 8; rows <= 48; rows += 8)
            check_bands(layouts[i].format, layouts[i].format, rows);
    check_bands(&pel_rgb565_be, &pel_xrgb8888, 7);
}

TEST(errors)
{
    struct pel_display_memory memory;
    struct pel_display display;
    struct pel_rect grown = area;
    struct pel_surface small =
        surface_of(&pel_xrgb8888, whole_pixels, sizeof whole_pixels, WIDTH, 40);
    memory.screen = surface_of(&pel_xrgb8888, shown_pixels, sizeof shown_pixels,
                               WIDTH, HEIGHT);
    assert_int_equal(pel_display_memory_init(NULL, &memory), PEL_ERROR_NULL);
    memory.screen.bounds.x0 = 1;
    assert_int_equal(pel_display_memory_init(&display, &memory),
                     PEL_ERROR_SIZE);
    memory.screen.bounds.x0 = 0;
    assert_int_equal(pel_display_memory_init(&display, &memory), PEL_OK);
    assert_int_equal(pel_display_begin(&display, &area, &small),
                     PEL_ERROR_SIZE);
    pel_display_align(&display, &grown);
    assert_memory_equal(&grown, &area, sizeof area);
    small.clip.x1 = 0;
    assert_int_equal(pel_display_flush(&display, &small), PEL_OK);
}
