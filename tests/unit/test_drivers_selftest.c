/* The self-test and the display that reports a number for each frame. */
#include <string.h>

#include "core/pel.h"
#include "drivers/display_crc.h"
#include "drivers/display_memory.h"
#include "drivers/selftest.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"

static uint32_t memory[PEL_SELFTEST_SIZE / 4];

TEST(every_format_passes)
{
    for (int i = 0; i < LAYOUT_COUNT; i++)
        if (pel_selftest(layouts[i].format, memory, sizeof memory) != PEL_OK)
            fail_msg("%s", layouts[i].name);
    assert_int_equal(pel_selftest_all(memory, sizeof memory), PEL_OK);
}

static void fill_too_far(const struct pel_spans *spans, uint32_t pixel)
{
    pel_rgb565_le.fill(spans, pixel ^ 1);
}

TEST(what_is_wrong_fails)
{
    struct pel_format wrong = pel_rgb565_le;
    assert_int_equal(pel_selftest(&wrong, memory, sizeof memory), PEL_OK);
    wrong.fill = fill_too_far;
    assert_int_equal(pel_selftest(&wrong, memory, sizeof memory),
                     PEL_ERROR_DEVICE);
    wrong.id = 200;
    assert_int_equal(pel_selftest(&wrong, memory, sizeof memory),
                     PEL_ERROR_FORMAT);
    assert_int_equal(pel_selftest(&pel_rgb565_le_fill, memory, sizeof memory),
                     PEL_ERROR_FORMAT);
    assert_int_equal(pel_selftest(&pel_rgb565_be_fill, memory, sizeof memory),
                     PEL_ERROR_FORMAT);
    assert_int_equal(pel_selftest(NULL, memory, sizeof memory), PEL_ERROR_NULL);
    assert_int_equal(pel_selftest(&pel_xrgb8888, memory, sizeof memory - 1),
                     PEL_ERROR_SIZE);
    assert_int_equal(pel_selftest_all(memory, 9), PEL_ERROR_SIZE);
}

enum { WIDTH = 20, HEIGHT = 24 };

static uint16_t screen[WIDTH * HEIGHT], band[WIDTH * HEIGHT];
static uint32_t sums[2];
static int frames;

static void note(const struct pel_display_crc *crc)
{
    sums[frames++ % 2] = crc->sum;
}

/* A frame in bands, from below where lines < 0. */
static uint32_t frame(const struct pel_display *display,
                      const struct pel_format *format, int32_t lines,
                      pel_color color)
{
    const struct pel_flat flat = PEL_FLAT(color);
    const struct pel_point center = PEL_AT(9, 11);
    const int32_t step = lines < 0 ? -lines : lines;
    for (int32_t i = 0; i < HEIGHT; i += step) {
        const int32_t y = lines < 0 ? HEIGHT - step - i : i;
        struct pel_surface s;
        assert_int_equal(
            pel_surface_init(&s, format, band, sizeof band,
                             &(struct pel_rect){0, y, WIDTH, y + step}),
            PEL_OK);
        pel_clear(&s, PEL_RGB(1, 2, 3));
        pel_circle(&s, center, PEL_PX(8), &flat.paint);
        assert_int_equal(pel_display_flush(display, &s), PEL_OK);
    }
    assert_int_equal(pel_display_flip(display), PEL_OK);
    return sums[(frames - 1) % 2];
}

TEST(a_number_for_each_frame)
{
    struct pel_display_memory shown;
    struct pel_display panel, display;
    struct pel_display_crc crc = {.inner = &panel, .report = note};
    const pel_color red = PEL_RGB(255, 0, 0);
    assert_int_equal(pel_surface_init(&shown.screen, &pel_rgb565_be, screen,
                                      sizeof screen,
                                      &(struct pel_rect){0, 0, WIDTH, HEIGHT}),
                     PEL_OK);
    assert_int_equal(pel_display_memory_init(&panel, &shown), PEL_OK);
    assert_int_equal(pel_display_crc_init(&display, &crc), PEL_OK);
    const uint32_t whole = frame(&display, &pel_rgb565_be, HEIGHT, red);
    assert_memory_equal(screen, band, sizeof screen);
    /* Black, by Python's zlib.crc32. */
    assert_int_equal(frame(&display, &pel_rgb565_be, 8, 0), 0x901FD774);
    assert_int_equal(frame(&display, &pel_rgb565_be, 8, red), whole);
    assert_int_equal(frame(&display, &pel_rgb565_be, -4, red), whole);
    assert_int_equal(frame(&display, &pel_rgb565_le, -3, red), whole);
    assert_int_not_equal(frame(&display, &pel_rgb565_be, 8, PEL_RGB(0, 255, 0)),
                         whole);
    assert_int_equal(frames, 6);
    crc.inner = NULL;
    assert_int_equal(pel_display_crc_init(&display, &crc), PEL_ERROR_NULL);
}
