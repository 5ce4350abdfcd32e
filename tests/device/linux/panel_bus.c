/* A panel on a Linux board whose system calls are played here: what spidev,
 * i2c-dev and the lines get makes the glass show the frame, straight from the
 * frame's memory, in messages that spidev takes; and every call fails once with
 * every errno. */
#include "tests/support/check.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include <pel/pel.h>

#include "panel_calls.h"

enum { DEVICES = 6, FAILING = 4 };

static struct panel_glass glass;

#define ST7789 .family = PANEL_DCS, .columns = 240, .rows = 320
#define OLED                                                                  \
    .family = PANEL_PAGES, .columns = 128, .rows = 64, .columns_backward = 1, \
    .rows_backward = 1

/* Each with the size of the display and its glass; the first is 240x240. */
static const struct {
    const char *name;
    int size[2];
    struct panel_glass glass;
} devices[DEVICES] = {
    {"st7789,spi=/dev/spidev0.0,speed=40M,size=240x240,dc=GPIO25,"
     "reset=gpiochip0:27,light=GPIO18",
     {240, 240},
     {ST7789}},
    {"st7789,spi=/dev/spidev0.0,speed=40000000,size=135x240,rotation=90,"
     "mode=3,dc=GPIO25,brightness=200",
     {240, 135},
     {ST7789, .left = 52, .top = 40}},
    {"ssd1306,i2c=/dev/i2c-1,address=0x3d", {128, 64}, {OLED}},
    {"ssd1306,i2c=/dev/i2c-1,address=61,size=128x32,rotation=270,inverted",
     {32, 128},
     {OLED}},
    {"ili9488,spi=/dev/spidev0.0,speed=40M,mode=3,dc=GPIO25,rotation=180",
     {320, 480},
     {.family = PANEL_DCS,
      .columns = 320,
      .rows = 480,
      .columns_backward = true}},
    {"st7735,spi=/dev/spidev0.0,speed=40M,mode=3,dc=GPIO25,size=80x160,"
     "rotation=270",
     {160, 80},
     {.family = PANEL_DCS,
      .columns = 132,
      .rows = 162,
      .columns_backward = true,
      .rows_backward = true,
      .left = 26,
      .top = 1}},
};

static int open_device(int i)
{
    struct pel_panel_request request;
    wire.count = 0;
    calls = lines_open = 0;
    messages = lines_set = bytes_sent = bytes_copied = 0;
    message.text[0] = 0;
    assert_int_equal(pel_panel_parse(&request, devices[i].name, &message), 0);
    const int error = pel_display_panel_open(&panel, &request, &message);
    assert_int_equal(wire.count, 0);
    return error ? error : pel_display_panel_start(&display, &panel, &request);
}

/* A frame of noise, or a part of it; NULL: all. */
static enum pel_status flush(const struct pel_rect *part)
{
    const struct pel_rect whole = {0, 0, display.width, display.height};
    struct pel_surface s;
    part = part ? part : &whole;
    assert_int_equal(pel_display_begin(&display, part, &s), PEL_OK);
    uint8_t *bytes = s.pixels;
    const int32_t n = display.width * display.height * display.format->bits / 8;
    for (int32_t i = 0; i < n; i++)
        bytes[i] = (uint8_t)rand();
    return pel_display_flush(&display, &s);
}

static void look(int i)
{
    glass = devices[i].glass;
    panel_glass_reset(&glass);
    panel_glass_take(&glass, &wire, 0);
}

static void check_glass(int i)
{
    int at[2];
    look(i);
    assert_true(glass.on && glass.awake);
    if (!panel_glass_shows(&glass, &panel.frame, panel.panel.rotation, at))
        fail_msg("%s: pixel %d, %d", devices[i].name, at[0], at[1]);
}

TEST(frames)
{
    for (int i = 0; i < DEVICES; i++) {
        assert_int_equal(open_device(i), 0);
        assert_int_equal(display.width, devices[i].size[0]);
        assert_int_equal(display.height, devices[i].size[1]);
        assert_int_equal(levels[2], i == 0);
        assert_int_equal(mode_set, i == 0 ? 0 : 3);
        assert_int_equal(flush(NULL), PEL_OK);
        check_glass(i);
        pel_display_panel_close(&panel);
        assert_int_equal(lines_open, 0);
        assert_int_equal(levels[2], 0);
    }
}

/* What a 240x240 frame, and a window of 10x100, cost. */
TEST(system_calls)
{
    const struct pel_rect part = {7, 50, 17, 150};
    assert_int_equal(open_device(0), 0);
    messages = lines_set = bytes_sent = 0;
    assert_int_equal(flush(NULL), PEL_OK);
    assert_int_equal(bytes_sent, 240 * 240 * 2 + 11);
    assert_int_equal(messages, 5 + (240 * 240 * 2 + 4095) / 4096);
    assert_int_equal(lines_set, 5);
    assert_int_equal(bytes_copied, 0);
    messages = 0;
    assert_int_equal(flush(&part), PEL_OK);
    assert_int_equal(messages, 5 + (100 + 31) / 32);
    assert_int_equal(bytes_copied, 0);
    pel_display_panel_close(&panel);
}

TEST(every_call_that_fails)
{
    static const int errors[] = {EIO,    EINVAL,   ENODEV,    EBUSY,
                                 EACCES, ENOENT,   ENXIO,     EREMOTEIO,
                                 ENOMEM, EMSGSIZE, ETIMEDOUT, ESHUTDOWN,
                                 ENOTTY, EINTR,    EAGAIN};
    const int files = next_descriptor();
    for (size_t k = 0; k < FAILING * sizeof errors / sizeof *errors; k++) {
        const int i = (int)k % FAILING;
        error_given = errors[k / FAILING];
        calls = fail_at = 0;
        do {
            fail_at++;
            int error = open_device(i);
            const bool refused = error;
            if (!error)
                error = flush(NULL);
            const bool failed = calls >= fail_at;
            const bool told = message.text[0];
            pel_display_panel_close(&panel);
            look(i); /* whatever it was told, it is dark */
            assert_false(refused && (glass.on || glass.awake));
            if (error_given != EINTR)
                assert_int_equal(failed, error != 0);
            assert_int_equal(error != 0, told);
            assert_int_equal(lines_open, 0);
            assert_int_equal(next_descriptor(), files);
        } while (calls >= fail_at);
    }
    fail_at = 0;
}

/* A second program is refused before it has changed anything. */
TEST(chips_of_others)
{
    mode_set = -1;
    fail_at = 1; /* the line D/C */
    error_given = EBUSY;
    assert_int_equal(open_device(1), EBUSY);
    assert_int_equal(calls, 1);
    fail_at = 3; /* the lock */
    error_given = EAGAIN;
    assert_int_equal(open_device(2), EAGAIN);
    assert_non_null(strstr(message.text, "another program has the chip at"));
    assert_int_equal(calls, 3);
    assert_int_equal(mode_set, -1);
    fail_at = 0;
}

TEST(i2c_of_other_chips)
{
    static const uint8_t bytes[129];
    const struct pel_bus_request request = {
        .i2c = "/dev/i2c-1", .address = 0x3D, .plain = true};
    struct pel_bus_linux bus;
    assert_int_equal(pel_bus_linux_open(&bus, &request, &message), 0);
    assert_null(bus.bus.data);
    assert_int_equal(bus.bus.command(&bus.bus, bytes, 129, NULL, 0),
                     PEL_ERROR_SIZE);
    assert_non_null(strstr(message.text, "more than 128 bytes"));
    pel_bus_linux_close(&bus);
}

TEST(glass_that_is_refused)
{
    struct pel_panel_request request;
    static const char *const names[][2] = {
        {"st7789,spi=/dev/a,dc=GPIO25,size=241x10", "beyond the memory"},
        {"ssd1306,i2c=/dev/a,address=61,size=128x60", "multiples of 8 rows"}};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        wire.count = 0;
        assert_int_equal(pel_panel_parse(&request, names[i][0], &message), 0);
        assert_int_equal(pel_display_panel_open(&panel, &request, &message), 0);
        assert_int_equal(pel_display_panel_start(&display, &panel, &request),
                         EINVAL);
        assert_non_null(strstr(message.text, names[i][1]));
        pel_display_panel_close(&panel);
        assert_int_equal(wire.count, 0);
    }
}
