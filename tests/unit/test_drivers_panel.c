/* Panels: what is sent over the bus makes the glass show the picture, for every
 * chip, module, rotation and window. */
#include "tests/support/check.h"
#include "tests/support/layouts.h"

#include <string.h>

#include "drivers/panel.h"
#include "tests/support/cases.h"
#include "tests/support/panel_glass.h"

struct module {
    const char *name;
    const struct pel_panel_chip *chip[2]; /* by rotation & 1 */
    struct panel_glass glass;
    int width, height;
    bool inverted; /* as the usual module wants it */
    int bgr;       /* the bit of the direction byte, as it wants it */
    int shift;     /* how many bits of brightness less than 8 there are */
    struct pel_panel panel;
};

/* The glass of each family: the size of its memory, and where it lies there. */
#define DCS(columns_, rows_, backward, left_, top_)              \
    {                                                            \
        .family = PANEL_DCS, .columns = columns_, .rows = rows_, \
        .columns_backward = backward, .left = left_, .top = top_ \
    }
#define ST7735(columns_, rows_, left_, top_)                            \
    {                                                                   \
        .family = PANEL_DCS, .columns = columns_, .rows = rows_,        \
        .columns_backward = true, .rows_backward = true, .left = left_, \
        .top = top_                                                     \
    }
#define SSD1351(top_)                                         \
    {                                                         \
        .family = PANEL_SSD1351, .columns = 128, .rows = 128, \
        .rows_backward = true, .top = top_                    \
    }
#define PAGES(columns_, left_, top_)                                    \
    {                                                                   \
        .family = PANEL_PAGES, .columns = columns_, .rows = 64,         \
        .columns_backward = true, .rows_backward = true, .left = left_, \
        .top = top_                                                     \
    }
#define SH1107(columns_)                                         \
    {                                                            \
        .family = PANEL_SH1107, .columns = columns_, .rows = 128 \
    }
#define ST7565                                             \
    {                                                      \
        .family = PANEL_PAGES, .columns = 132, .rows = 64, \
        .columns_backward = true                           \
    }
#define PCD8544(left_, top_)                                               \
    {                                                                      \
        .family = PANEL_PCD8544, .columns = 84, .rows = 48, .left = left_, \
        .top = top_                                                        \
    }
#define PART(width_, height_, left_, top_) \
    .width = width_, .height = height_, .left = left_, .top = top_
#define WHOLE .rotation = 0
/* Behind `shift` comes what the panel is told. */
#define MODULE(name, upright, turned, glass, width, height, inverted, bgr, \
               shift, ...)                                                 \
    {                                                                      \
        name, {&pel_panel_##upright, &pel_panel_##turned}, glass, width,   \
            height, inverted, bgr, shift,                                  \
        {                                                                  \
            __VA_ARGS__                                                    \
        }                                                                  \
    }

static const struct module modules[] = {
    MODULE("st7789 240x320", st7789, st7789, DCS(240, 320, false, 0, 0), 240,
           320, true, 0, 0, WHOLE),
    MODULE("st7789 240x240", st7789, st7789, DCS(240, 320, false, 0, 0), 240,
           240, true, 0, 0, PEL_PANEL_240X240),
    MODULE("st7789 135x240", st7789, st7789, DCS(240, 320, false, 52, 40), 135,
           240, true, 0, 0, PEL_PANEL_135X240),
    MODULE("st7789 170x320", st7789, st7789, DCS(240, 320, false, 35, 0), 170,
           320, true, 0, 0, PEL_PANEL_170X320),
    MODULE("st7789 240x280", st7789, st7789, DCS(240, 320, false, 0, 20), 240,
           280, true, 0, 0, PEL_PANEL_240X280),
    MODULE("st7789, other glass", st7789, st7789, DCS(240, 320, false, 7, 100),
           80, 160, false, 8, 0, PART(80, 160, 7, 100), .inverted = true,
           .swapped = true),
    MODULE("ili9341", ili9341, ili9341, DCS(240, 320, true, 0, 0), 240, 320,
           false, 8, 0, WHOLE),
    MODULE("gc9a01", gc9a01, gc9a01, DCS(240, 240, false, 0, 0), 240, 240, true,
           8, 0, WHOLE),
    MODULE("ssd1351", ssd1351, ssd1351, SSD1351(0), 128, 128, false, 4, 4,
           WHOLE),
    MODULE("ssd1351 128x96", ssd1351, ssd1351, SSD1351(32), 128, 96, false, 0,
           4, PART(128, 96, 0, 32), .swapped = true),
    MODULE("ssd1306", ssd1306, ssd1306_turned, PAGES(128, 0, 0), 128, 64, false,
           0, 0, WHOLE),
    MODULE("ssd1306 128x32", ssd1306_32, ssd1306_32_turned, PAGES(128, 0, 0),
           128, 32, true, 0, 0, .inverted = true),
    MODULE("ssd1306 72x40", ssd1306, ssd1306_turned, PAGES(128, 28, 16), 72, 40,
           false, 0, 0, PART(72, 40, 28, 16)),
    MODULE("sh1106", sh1106, sh1106_turned, PAGES(132, 2, 0), 128, 64, false, 0,
           0, WHOLE),
    MODULE("st7735 128x160", st7735, st7735, ST7735(132, 162, 2, 1), 128, 160,
           false, 8, 8, PEL_PANEL_128X160),
    MODULE("st7735 80x160", st7735, st7735, ST7735(132, 162, 26, 1), 80, 160,
           true, 8, 8, PEL_PANEL_80X160, .inverted = true),
    MODULE("st7735, black tab", st7735_128x160, st7735_128x160,
           ST7735(128, 160, 0, 0), 128, 160, false, 0, 8, WHOLE),
    MODULE("st7735 80x160, RGB", st7735_128x160, st7735_128x160,
           ST7735(128, 160, 24, 0), 80, 160, false, 0, 8, PART(80, 160, 24, 0)),
    MODULE("st7735 128x128", st7735_132x132, st7735_132x132,
           ST7735(132, 132, 2, 3), 128, 128, false, 8, 8, PEL_PANEL_128X128),
    MODULE("ili9488", ili9488, ili9488, DCS(320, 480, true, 0, 0), 320, 480,
           false, 8, 0, WHOLE),
    MODULE("st7796", st7796, st7796, DCS(320, 480, true, 0, 0), 320, 480, false,
           8, 0, WHOLE),
    MODULE("ili9342", ili9342, ili9342, DCS(320, 240, false, 0, 0), 320, 240,
           true, 8, 0, WHOLE),
    MODULE("ssd1309", ssd1309, ssd1309_turned, PAGES(128, 0, 0), 128, 64, false,
           0, 0, WHOLE),
    MODULE("sh1107", sh1107, sh1107_turned, SH1107(64), 64, 128, false, 0, 0,
           WHOLE),
    MODULE("sh1107 128x128", sh1107_128, sh1107_128_turned, SH1107(128), 128,
           128, false, 0, 0, WHOLE),
    MODULE("st7565", st7565, st7565_turned, ST7565, 128, 64, false, 0, 2,
           WHOLE),
    MODULE("pcd8544", pcd8544, pcd8544_turned, PCD8544(0, 0), 84, 48, false, 0,
           1, WHOLE),
    MODULE("pcd8544, a part", pcd8544, pcd8544_turned, PCD8544(10, 8), 60, 32,
           true, 0, 1, PART(60, 32, 10, 8), .inverted = true),
};
enum { MODULES = sizeof modules / sizeof *modules, BYTES = 328 * 488 * 3 };

static struct bus_log bus;
static uint8_t memory[BYTES], shown[BYTES];

/* A module under test, and `shown`, what its screen is to show. */
struct fixture {
    const struct module *module;
    struct pel_panel panel;
    struct panel_glass glass;
    struct pel_display display;
    struct pel_surface shown;
    int read; /* of the log */
};

static const struct pel_format *format_of(const struct module *m, int rotation)
{
    return m->chip[0] == &pel_panel_ili9488 ? &pel_bgr888
           : m->glass.family < PANEL_PAGES  ? &pel_rgb565_be
           : rotation & 1                   ? &pel_mono1
                                            : &pel_mono1_pages;
}

static enum pel_status set_up(struct fixture *f, const struct module *m,
                              int rotation)
{
    f->module = m;
    f->panel = m->panel;
    f->glass = m->glass;
    f->panel.chip = m->chip[rotation & 1];
    f->panel.bus = &bus.bus;
    f->panel.format = format_of(m, rotation);
    f->panel.rotation = (uint8_t)rotation;
    f->read = 0;
    bus.pixels = memory;
    bus.size = sizeof memory;
    bus_log_init(&bus);
    panel_glass_reset(&f->glass);
    const enum pel_status status = pel_panel_init(&f->display, &f->panel);
    memset(shown, 0, sizeof shown);
    if (status == PEL_OK)
        f->shown = surface_of(f->panel.format, shown, sizeof shown,
                              f->display.width, f->display.height);
    return status;
}

static void check_glass(struct fixture *f)
{
    int at[2];
    f->read = panel_glass_take(&f->glass, &bus, f->read);
    if (!panel_glass_shows(&f->glass, &f->shown, f->panel.rotation, at))
        fail_msg("%s, rotation %d: (%d, %d) of the glass is %04x; %s",
                 f->module->name, f->panel.rotation, at[0], at[1],
                 panel_glass_pixel(&f->glass, at[0], at[1]), cases_replay());
}

static void check_lines(const struct fixture *f)
{
    const struct panel_glass *g = &f->glass;
    const struct pel_panel_chip *chip = f->panel.chip;
    const bool narrow =
        chip == &pel_panel_ssd1306_32 || chip == &pel_panel_ssd1306_32_turned;
    if (g->family == PANEL_PAGES)
        assert_int_equal(g->multiplex, narrow ? 32 : 64);
    if (g->family == PANEL_SH1107) {
        assert_int_equal(g->multiplex, g->columns);
        assert_int_equal(g->offset, g->columns == 64 ? 96 : 0);
    }
}

static void check_state(const struct fixture *f)
{
    const struct panel_glass *g = &f->glass;
    assert_true(g->on && g->awake);
    assert_true(g->inverted == f->module->inverted);
    if (g->family == PANEL_DCS) {
        assert_int_equal(g->depth & 7,
                         f->panel.chip == &pel_panel_ili9488 ? 6 : 5);
        assert_int_equal(g->brightness, 255 >> f->module->shift);
    }
    if (g->family < PANEL_PAGES)
        assert_int_equal(g->direction & (g->family == PANEL_DCS ? 8 : 4),
                         f->module->bgr);
    check_lines(f);
}

static struct pel_rect any_area(struct random *r, const struct pel_display *d)
{
    const struct pel_rect whole = {0, 0, d->width, d->height};
    const int32_t x = random_between(r, 0, d->width - 1);
    const int32_t y = random_between(r, 0, d->height - 1);
    struct pel_rect area = {x, y, random_between(r, x + 1, d->width),
                            random_between(r, y + 1, d->height)};
    if (random_word(r) % 4 == 0)
        area = whole;
    pel_display_align(d, &area);
    return area;
}

/* Random pixels: a band or tile of its own, or a part of a larger one. */
static struct pel_surface any_surface(struct random *r,
                                      const struct pel_display *d,
                                      const struct pel_rect *area)
{
    const struct pel_rect whole = {0, 0, d->width, d->height};
    struct pel_surface s;
    const bool part = random_word(r) & 1;
    assert_int_equal(pel_surface_init(&s, d->format, memory, sizeof memory,
                                      part ? &whole : area),
                     PEL_OK);
    for (size_t i = 0; i < sizeof memory; i++)
        memory[i] = (uint8_t)random_word(r);
    assert_int_equal(pel_display_begin(d, area, &s), PEL_OK);
    return s;
}

static void flush_any(struct fixture *f, struct random *r)
{
    const struct pel_rect area = any_area(r, &f->display);
    struct pel_surface s = any_surface(r, &f->display, &area);
    pel_surface_clip(&f->shown, &area);
    for (int32_t y = area.y0; y < area.y1; y++)
        for (int32_t x = area.x0; x < area.x1; x += 16) {
            pel_color colors[16];
            const int32_t n = pel_min(16, area.x1 - x);
            s.format->load(&s, x, y, n, colors);
            f->shown.format->put(&f->shown, x, y, n, colors);
        }
    assert_int_equal(pel_display_flush(&f->display, &s), PEL_OK);
    assert_int_equal(pel_display_wait(&f->display), PEL_OK);
}

TEST(glass_shows_the_picture)
{
    static struct fixture f;
    for (struct cases c = cases_of(MODULES * 4 * 2); cases_next(&c);) {
        const uint64_t i = c.next - 1;
        bus.dma = i % 2;
        assert_int_equal(
            set_up(&f, &modules[i / 8 % MODULES], (int)(i / 2 % 4)), PEL_OK);
        assert_true(bus.ms >= (f.glass.family == PANEL_DCS ? 360 : 100));
        for (int n = 0; n < 4; n++) {
            if (n)
                bus.count = f.read = 0;
            flush_any(&f, &c.random);
            check_glass(&f);
        }
        check_state(&f);
    }
}

TEST(brightness_and_sleep)
{
    static struct fixture f;
    for (int i = 0; i < MODULES * 2; i++) {
        bus.dma = i & 1;
        assert_int_equal(set_up(&f, &modules[i / 2], 0), PEL_OK);
        pel_panel_brightness(&f.panel, 0x9C);
        pel_panel_sleep(&f.panel, true);
        f.read = panel_glass_take(&f.glass, &bus, f.read);
        assert_int_equal(f.glass.brightness, 0x9C >> f.module->shift);
        assert_false(f.glass.on && f.glass.family != PANEL_PCD8544);
        assert_false(f.glass.awake);
        pel_panel_sleep(&f.panel, false);
        panel_glass_take(&f.glass, &bus, f.read);
        assert_true(f.glass.on && f.glass.awake);
    }
}

/* Init and a flush, in which the n-th call of the bus fails: its error comes
 * out, and nothing is sent after it. */
TEST(every_call_that_fails)
{
    static struct fixture f;
    for (int i = 0; i < MODULES * 8; i++) {
        enum pel_status status = PEL_ERROR_DEVICE;
        bus.dma = i & 1;
        for (bus.fail_at = 1; status != PEL_OK; bus.fail_at++) {
            status = set_up(&f, &modules[i / 8], i / 2 % 4);
            if (status == PEL_OK) {
                struct pel_surface s =
                    surface_of(f.panel.format, memory, sizeof memory,
                               f.display.width, f.display.height);
                status = pel_display_flush(&f.display, &s);
            }
            if (status == PEL_OK)
                status = pel_display_wait(&f.display);
            assert_int_equal(
                status, bus.calls < bus.fail_at ? PEL_OK : PEL_ERROR_DEVICE);
            assert_true(bus.calls <= bus.fail_at);
        }
    }
    bus.fail_at = 0;
}

TEST(what_is_refused)
{
    static struct fixture f;
    struct pel_panel wide = {.chip = &pel_panel_st7789,
                             .bus = &bus.bus,
                             .format = &pel_rgb565_be,
                             PEL_PANEL_135X240};
    struct pel_display display;
    struct pel_surface s;
    assert_int_equal(pel_panel_init(NULL, &wide), PEL_ERROR_NULL);
    assert_int_equal(pel_panel_init(&display, NULL), PEL_ERROR_NULL);
    wide.left = 106;
    assert_int_equal(pel_panel_init(&display, &wide), PEL_ERROR_SIZE);
    wide.left = 105;
    wide.top = 81;
    assert_int_equal(pel_panel_init(&display, &wide), PEL_ERROR_SIZE);
    wide.width = 0; /* the chip's, with a height of its own */
    wide.left = 0;
    wide.top = 80;
    assert_int_equal(pel_panel_init(&display, &wide), PEL_OK);
    wide.format = &pel_rgb565_le;
    assert_int_equal(pel_panel_init(&display, &wide), PEL_ERROR_FORMAT);
    wide.format = NULL;
    assert_int_equal(pel_panel_init(&display, &wide), PEL_ERROR_NULL);
    for (int i = 0; i < MODULES * 4; i++) {
        const struct module *m = &modules[i / 4];
        assert_int_equal(set_up(&f, m, i % 4), PEL_OK);
        s = surface_of(f.panel.format, memory, sizeof memory,
                       f.display.width + 8, f.display.height + 8);
        const int calls = bus.calls;
        assert_int_equal(pel_display_flush(&f.display, &s), PEL_ERROR_SIZE);
        s.clip = (struct pel_rect){3, 3, 11, 11};
        if (m->glass.family >= PANEL_PAGES)
            assert_int_equal(pel_display_flush(&f.display, &s), PEL_ERROR_SIZE);
        s.clip.x1 = 3;
        assert_int_equal(pel_display_flush(&f.display, &s), PEL_OK);
        s = surface_of(&pel_gray8, memory, sizeof memory, f.display.width,
                       f.display.height);
        assert_int_equal(pel_display_flush(&f.display, &s), PEL_ERROR_FORMAT);
        assert_int_equal(bus.calls, calls);
    }
    struct module cut = modules[10];
    for (int i = 0; i < 4; i++) {
        cut.panel.height = i & 2 ? 60 : 56;
        cut.panel.top = i & 2 ? 0 : 4;
        assert_int_equal(set_up(&f, &cut, i & 1), PEL_ERROR_SIZE);
    }
    cut.chip[1] = cut.chip[0];
    assert_int_equal(set_up(&f, &cut, 1), PEL_ERROR_FORMAT);
}

/* A bus that takes commands alone, as touch controllers do, is no panel's. */
TEST(half_a_bus)
{
    struct pel_bus half = bus.bus;
    struct pel_panel panel = {
        .chip = &pel_panel_st7789, .bus = &half, .format = &pel_rgb565_be};
    struct pel_display display;
    half.data = NULL;
    assert_int_equal(pel_panel_init(&display, &panel), PEL_ERROR_NULL);
    half = bus.bus;
    half.pause = NULL;
    assert_int_equal(pel_panel_init(&display, &panel), PEL_ERROR_NULL);
}
