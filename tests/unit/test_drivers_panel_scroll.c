/* Scrolling by the panel: the model of the chip shows the picture as it would
 * be after the same moves in memory, in all rotations. */
#include "tests/support/check.h"
#include "tests/support/layouts.h"

#include <string.h>

#include "drivers/panel_scroll.h"
#include "tests/support/cases.h"
#include "tests/support/panel_glass.h"

static const struct module {
    const struct pel_panel_chip *chip;
    struct panel_glass glass;
    int width, height;
    struct pel_panel panel;
} modules[] = {
    {&pel_panel_st7789,
     {.family = PANEL_DCS, .columns = 240, .rows = 320},
     240,
     320,
     {.rotation = 0}},
    {&pel_panel_st7789,
     {.family = PANEL_DCS, .columns = 240, .rows = 320, .left = 52, .top = 40},
     135,
     240,
     {PEL_PANEL_135X240}},
    {&pel_panel_ili9341,
     {.family = PANEL_DCS,
      .columns = 240,
      .rows = 320,
      .columns_backward = true},
     240,
     320,
     {.rotation = 0}},
    {&pel_panel_st7735,
     {.family = PANEL_DCS,
      .columns = 132,
      .rows = 162,
      .columns_backward = true,
      .rows_backward = true,
      .left = 26,
      .top = 1},
     80,
     160,
     {PEL_PANEL_80X160}},
    {&pel_panel_ili9488,
     {.family = PANEL_DCS,
      .columns = 320,
      .rows = 480,
      .columns_backward = true},
     320,
     480,
     {.rotation = 0}}};
enum { MODULES = sizeof modules / sizeof *modules, BYTES = 320 * 480 * 3 };

static struct bus_log bus;
static uint8_t memory[BYTES], shown_bytes[BYTES], before[BYTES];
static struct pel_panel panel;
static struct panel_glass glass;
static struct pel_display display;
static struct pel_surface shown; /* what the screen is to show */
static int taken;                /* of the log */

static void set_up(const struct module *m, int rotation)
{
    panel = m->panel;
    glass = m->glass;
    panel.chip = m->chip;
    panel.bus = &bus.bus;
    panel.format = m->chip == &pel_panel_ili9488 ? &pel_bgr888 : &pel_rgb565_be;
    panel.rotation = (uint8_t)rotation;
    taken = 0;
    bus.pixels = memory;
    bus.size = sizeof memory;
    bus_log_init(&bus);
    panel_glass_reset(&glass);
    assert_int_equal(pel_panel_init(&display, &panel), PEL_OK);
    memset(shown_bytes, 0, sizeof shown_bytes);
    shown = surface_of(panel.format, shown_bytes, sizeof shown_bytes,
                       display.width, display.height);
}

static void check_glass(void)
{
    int at[2];
    taken = panel_glass_take(&glass, &bus, taken);
    if (!panel_glass_shows(&glass, &shown, panel.rotation, at))
        fail_msg("rotation %d: (%d, %d) of the glass is %06x; %s",
                 panel.rotation, at[0], at[1],
                 (unsigned)panel_glass_pixel(&glass, at[0], at[1]),
                 cases_replay());
}

/* Noise somewhere. */
static void flush_any(struct random *r, const struct pel_display *rolling)
{
    const int32_t x = random_between(r, 0, rolling->width - 1);
    const int32_t y = random_between(r, 0, rolling->height - 1);
    const struct pel_rect area = {x, y,
                                  random_between(r, x + 1, rolling->width),
                                  random_between(r, y + 1, rolling->height)};
    const int32_t bytes = panel.format->bits / 8;
    struct pel_surface s = surface_of(panel.format, memory, sizeof memory,
                                      rolling->width, rolling->height);
    const uint32_t noise = random_word(r);
    for (uint32_t i = 0; i < sizeof memory; i++)
        memory[i] = (uint8_t)((i + noise) * 2654435761u >> 24);
    assert_int_equal(pel_display_begin(rolling, &area, &s), PEL_OK);
    assert_int_equal(pel_display_flush(rolling, &s), PEL_OK);
    assert_int_equal(pel_display_wait(rolling), PEL_OK);
    for (int32_t row = area.y0; row < area.y1; row++)
        memcpy(pel_surface_line(&shown, row) + area.x0 * bytes,
               pel_surface_line(&s, row) + area.x0 * bytes,
               (size_t)((area.x1 - area.x0) * bytes));
}

/* Line k shows what line k + n did, between from and to, around. */
static void roll_shown(int32_t from, int32_t to, int32_t n)
{
    const int32_t bytes = panel.format->bits / 8, lines = to - from;
    const bool turned = panel.rotation & 1;
    memcpy(before, shown_bytes, sizeof before);
    for (int32_t y = 0; y < shown.bounds.y1; y++)
        for (int32_t x = 0; x < shown.bounds.x1; x++) {
            const int32_t line = (turned ? x : y) - from;
            const int32_t other = from + ((line + n) % lines + lines) % lines;
            if (line >= 0 && line < lines)
                memcpy(pel_surface_line(&shown, y) + x * bytes,
                       before + (turned ? y : other) * shown.stride +
                           (turned ? other : x) * bytes,
                       (size_t)bytes);
        }
}

TEST(glass_scrolls)
{
    for (struct cases c = cases_of(MODULES * 4 * 4); cases_next(&c);) {
        struct random *const r = &c.random;
        const uint64_t i = c.next - 1;
        struct pel_panel_scroll scroll;
        struct pel_display rolling;
        bus.dma = i % 2;
        set_up(&modules[i / 16 % MODULES], (int)(i / 4 % 4));
        const int32_t most =
            panel.rotation & 1 ? display.width : display.height;
        const int32_t from = random_between(r, 0, most - 1);
        const int32_t to = random_between(r, from + 1, most);
        assert_int_equal(
            pel_panel_scroll_init(&rolling, &scroll, &display, from, to),
            PEL_OK);
        for (int k = 0; k < 4; k++) {
            const int32_t n = random_between(r, -700, 700);
            flush_any(r, &rolling);
            check_glass();
            assert_int_equal(pel_panel_scroll_by(&scroll, n), PEL_OK);
            roll_shown(from, to, n);
            check_glass();
            bus.count = taken = 0;
        }
    }
}

TEST(what_does_not_scroll)
{
    static const int32_t wrong[][2] = {
        {-1, 9}, {9, 9}, {9, 8}, {0, 321}, {320, 321}};
    struct pel_panel_scroll s;
    struct pel_display rolling;
    set_up(&modules[0], 0);
    assert_int_equal(pel_panel_scroll_init(NULL, &s, &display, 0, 9),
                     PEL_ERROR_NULL);
    assert_int_equal(pel_panel_scroll_init(&rolling, NULL, &display, 0, 9),
                     PEL_ERROR_NULL);
    assert_int_equal(pel_panel_scroll_init(&rolling, &s, NULL, 0, 9),
                     PEL_ERROR_NULL);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_int_equal(pel_panel_scroll_init(&rolling, &s, &display,
                                               wrong[i][0], wrong[i][1]),
                         PEL_ERROR_SIZE);
    assert_int_equal(pel_panel_scroll_init(&rolling, &s, &display, 5, 90),
                     PEL_OK);
    struct pel_surface part =
        surface_of(panel.format, memory, sizeof memory, 240, 330);
    assert_int_equal(pel_display_flush(&rolling, &part), PEL_ERROR_SIZE);
    bus.fail_at = bus.calls + 1;
    assert_int_equal(pel_panel_scroll_by(&s, 1), PEL_ERROR_DEVICE);
    assert_int_equal(s.at, 0); /* as on the glass */
    bus.fail_at = 0;
    panel.chip = &pel_panel_ssd1306;
    assert_int_equal(pel_panel_scroll_init(&rolling, &s, &display, 0, 9),
                     PEL_ERROR_FORMAT);
}
