/* A parallel bus: what is on its lines, word by word, brings a serial bus's
 * bytes to the model of the chip, which shows the picture. */
#include "tests/support/check.h"
#include "tests/support/layouts.h"

#include <string.h>

#include "drivers/bus_8080.h"
#include "drivers/panel.h"
#include "tests/support/cases.h"
#include "tests/support/panel_glass.h"

enum { SIDE = 240 * 320 };

static struct bus_log sent; /* bytes, as a bus of 8 lines has them */
static bool writes;         /* 2Ch came last */
static int lines, resets;

/* Parameters are in the lower lines; a pixel of 16 lines is a word. */
static void words(const struct pel_bus_8080 *bus, bool data,
                  const uint16_t *word, size_t n)
{
    assert_in_range(n, 1, 32);
    assert_int_equal(bus->lines, lines);
    for (; n > 0; n--, word++) {
        if (!data)
            writes = *word == 0x2C;
        if (data && writes && lines == 16)
            sent.log[sent.count++] = (uint16_t)(BUS_LOG_DATA | *word >> 8);
        else
            assert_in_range(*word, 0, 255);
        sent.log[sent.count++] =
            (uint16_t)((data ? BUS_LOG_DATA : 0) | (*word & 255));
    }
}

static enum pel_status pause_bus(const struct pel_bus_8080 *bus, bool reset,
                                 uint32_t ms)
{
    (void)bus;
    resets += reset;
    return ms > 5000 ? PEL_ERROR_DEVICE : PEL_OK;
}

static struct pel_bus_8080 parallel = {.bus = PEL_BUS_8080(&parallel),
                                       .words = words,
                                       .pause = pause_bus,
                                       .write = 0x2C};

TEST(glass_shows_the_picture)
{
    static uint8_t pixels[SIDE * 2];
    for (struct cases c = cases_of(16); cases_next(&c);) {
        struct panel_glass glass = {
            .family = PANEL_DCS, .columns = 240, .rows = 320};
        struct pel_panel panel = {.chip = &pel_panel_st7789,
                                  .bus = &parallel.bus,
                                  .format = &pel_rgb565_be,
                                  .rotation = (uint8_t)(c.next / 2 % 4)};
        struct pel_display display;
        int at[2];
        lines = c.next % 2 ? 8 : 16;
        parallel.lines = (uint8_t)lines;
        sent.count = resets = 0;
        panel_glass_reset(&glass);
        assert_int_equal(pel_panel_init(&display, &panel), PEL_OK);
        assert_int_equal(resets, 1);
        struct pel_surface s = surface_of(panel.format, pixels, sizeof pixels,
                                          display.width, display.height);
        memset(pixels, 0, sizeof pixels);
        const struct pel_rect part = {
            random_between(&c.random, 0, 99), random_between(&c.random, 0, 99),
            random_between(&c.random, 100, display.width),
            random_between(&c.random, 100, display.height)};
        pel_surface_clip(&s, &part);
        for (int32_t y = part.y0; y < part.y1; y++)
            for (int32_t x = 2 * part.x0; x < 2 * part.x1; x++)
                pel_surface_line(&s, y)[x] = (uint8_t)random_word(&c.random);
        assert_int_equal(pel_display_flush(&display, &s), PEL_OK);
        panel_glass_take(&glass, &sent, 0);
        if (!panel_glass_shows(&glass, &s, panel.rotation, at))
            fail_msg("%d lines: (%d, %d) of the glass; %s", lines, at[0], at[1],
                     cases_replay());
    }
}

TEST(nothing_is_read)
{
    const uint8_t byte = 0x04;
    uint8_t answer;
    assert_int_equal(parallel.bus.command(&parallel.bus, &byte, 1, &answer, 1),
                     PEL_ERROR_DEVICE);
    assert_int_equal(parallel.bus.pause(&parallel.bus, false, 6000),
                     PEL_ERROR_DEVICE);
}

TEST(pause_is_required)
{
    struct pel_bus_8080 bus = {
        .bus = PEL_BUS_8080(&bus), .words = words, .lines = 8, .write = 0x2C};
    struct pel_panel panel = {
        .chip = &pel_panel_st7789, .bus = &bus.bus, .format = &pel_rgb565_be};
    struct pel_display display;
    assert_int_equal(pel_panel_init(&display, &panel), PEL_ERROR_DEVICE);
}
