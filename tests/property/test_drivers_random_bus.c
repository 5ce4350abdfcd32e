/* Buses that fail at any call, and answer anything: every chip of panels,
 * e-paper and touch, with any settings, ends each call in a bounded number of
 * bus calls, tells that the bus failed, and reads no byte beside the pixels. */
#include <stdio.h>
#include <stdlib.h>

#include "drivers/epaper.h"
#include "drivers/panel_scroll.h"
#include "drivers/touch.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"

/* A chip that stays busy is asked every millisecond for 60 s. */
enum { CALLS_MOST = 400000, SIDE = 40, OPERATIONS = 8 };

static struct random bus_random;
static uint32_t fails_of; /* of 256 calls */
static uint32_t busy_of;
static uint64_t calls, all_calls;
static bool failed;
static unsigned sum; /* so that all bytes are read */

static enum pel_status answer(void)
{
    all_calls++;
    if (++calls > CALLS_MOST)
        fail_msg("%d calls of the bus; %s", CALLS_MOST, cases_replay());
    if (random_word(&bus_random) % 256 >= fails_of)
        return PEL_OK;
    failed = true;
    return PEL_ERROR_DEVICE;
}

static void read_bytes(const uint8_t *bytes, size_t n)
{
    for (; n > 0; n--)
        sum += *bytes++;
}

static enum pel_status command(const struct pel_bus *bus, const uint8_t *bytes,
                               size_t n, uint8_t *got, size_t answers)
{
    (void)bus;
    assert_true(n >= 1);
    read_bytes(bytes, n);
    for (size_t i = 0; i < answers; i++)
        got[i] = (uint8_t)random_word(&bus_random);
    return answer();
}

static enum pel_status data(const struct pel_bus *bus,
                            const struct pel_bus_rows *rows)
{
    (void)bus;
    assert_true(rows->length >= 1 && rows->count >= 1);
    for (int32_t i = 0; i < rows->count; i++)
        read_bytes(rows->bytes + (ptrdiff_t)i * rows->stride,
                   (size_t)rows->length);
    return answer();
}

static enum pel_status pause_bus(const struct pel_bus *bus, bool reset,
                                 uint32_t ms)
{
    (void)bus, (void)reset, (void)ms;
    return answer();
}

static enum pel_status wait_bus(const struct pel_bus *bus)
{
    (void)bus;
    return answer();
}

static bool is_busy(const struct pel_epaper *paper)
{
    (void)paper;
    return random_word(&bus_random) % 256 < busy_of;
}

static struct pel_bus random_bus(struct random *r)
{
    static const uint16_t often[] = {0, 0, 4, 32, 128, 256};
    const struct pel_bus bus = {NULL, command,
                                random_word(r) % 64 ? data : NULL, pause_bus,
                                random_word(r) % 2 ? wait_bus : NULL};
    bus_random.state = random_word(r);
    fails_of = often[random_word(r) % 6];
    busy_of = random_word(r) % 512 == 0 ? 256 : random_word(r) % 128;
    return bus;
}

/* Begins a call of a driver. */
static void begin(void)
{
    calls = 0;
    failed = false;
}

static void end(enum pel_status status, const char *what)
{
    if (failed && status == PEL_OK)
        fail_msg("%s: the bus failed, and it said nothing; %s", what,
                 cases_replay());
}

/* A surface somewhere, with a clip that may leave the screen. */
static struct pel_surface random_surface(struct random *r,
                                         const struct pel_display *d)
{
    const struct pel_format *const format =
        d->format && random_word(r) % 16 ? d->format : &pel_gray8;
    const int32_t x = random_between(r, -1, 20) * 8,
                  y = random_between(r, -1, 20) * 8;
    const struct pel_rect bounds = {x, y, x + random_between(r, 1, SIDE),
                                    y + random_between(r, 1, SIDE)};
    const int32_t rows = format->id == PEL_FORMAT_MONO1_PAGES
                             ? (bounds.y1 - bounds.y0 + 7) / 8
                             : bounds.y1 - bounds.y0;
    const size_t size =
        (size_t)(pel_stride(format, bounds.x1 - bounds.x0) * rows);
    struct pel_rect clip = {x + random_between(r, -2, SIDE / 2),
                            y + random_between(r, -2, SIDE / 2),
                            x + random_between(r, 1, SIDE + 2),
                            y + random_between(r, 1, SIDE + 2)};
    struct pel_surface s;
    void *const pixels = calloc(1, size);
    assert_int_equal(pel_surface_init(&s, format, pixels, size, &bounds),
                     PEL_OK);
    if (random_word(r) % 4)
        pel_display_align(d, &clip);
    pel_surface_clip(&s, &clip);
    return s;
}

static void flush_any(struct random *r, const struct pel_display *d)
{
    struct pel_surface s = random_surface(r, d);
    begin();
    end(pel_display_flush(d, &s), "flush");
    begin();
    end(pel_display_wait(d), "wait");
    free(s.pixels);
}

static void flip(const struct pel_display *d)
{
    begin();
    end(pel_display_flip(d), "flip");
}

static void scroll_any(struct random *r, const struct pel_display *d)
{
    const int32_t from = random_between(r, -1, 200);
    struct pel_panel_scroll scroll;
    struct pel_display rolling;
    begin();
    const enum pel_status status = pel_panel_scroll_init(
        &rolling, &scroll, d, from, from + random_between(r, 0, 200));
    end(status, "scroll_init");
    if (status != PEL_OK)
        return;
    begin();
    end(pel_panel_scroll_by(&scroll, random_between(r, -400, 400)),
        "scroll_by");
    flush_any(r, &rolling);
}

static const struct pel_panel_chip *const chips[] = {
    &pel_panel_st7789,         &pel_panel_ili9341,
    &pel_panel_ili9342,        &pel_panel_ili9488,
    &pel_panel_st7796,         &pel_panel_gc9a01,
    &pel_panel_ssd1351,        &pel_panel_st7735,
    &pel_panel_st7735_128x160, &pel_panel_st7735_132x132,
    &pel_panel_ssd1306,        &pel_panel_ssd1306_turned,
    &pel_panel_ssd1306_32,     &pel_panel_ssd1306_32_turned,
    &pel_panel_ssd1309,        &pel_panel_ssd1309_turned,
    &pel_panel_sh1106,         &pel_panel_sh1106_turned,
    &pel_panel_sh1107,         &pel_panel_sh1107_turned,
    &pel_panel_sh1107_128,     &pel_panel_sh1107_128_turned,
    &pel_panel_st7565,         &pel_panel_st7565_turned,
    &pel_panel_pcd8544,        &pel_panel_pcd8544_turned,
    &pel_panel_ssd0323};

static uint16_t random_size(struct random *r)
{
    const uint32_t kind = random_word(r) % 8;
    return (uint16_t)(kind < 4    ? 0
                      : kind == 4 ? random_word(r)
                                  : random_word(r) % 160);
}

static void print_panel(const void *value)
{
    const struct pel_panel *const p = value;
    size_t chip = 0;
    while (chips[chip] != p->chip)
        chip++;
    fprintf(stderr,
            "chip %zu, format %d, %u x %u px from %u, %u, rotation %u\n", chip,
            p->format->id, p->width, p->height, p->left, p->top, p->rotation);
}

TEST(panels)
{
    static const struct pel_format *const formats[] = {
        &pel_rgb565_be, &pel_rgb565_be_fill, &pel_mono1_pages,
        &pel_mono1,     &pel_gray4,          &pel_bgr888};
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        struct random *const r = &c.random;
        const struct pel_bus bus = random_bus(r);
        struct pel_panel panel = {
            .chip = chips[random_word(r) % (sizeof chips / sizeof *chips)],
            .bus = &bus,
            .format = formats[random_word(r) % 6],
            .width = random_size(r),
            .height = random_size(r),
            .left = random_size(r),
            .top = random_size(r),
            .rotation = (uint8_t)random_word(r),
            .inverted = random_word(r) % 2,
            .swapped = random_word(r) % 2};
        struct pel_display display;
        cases_keep(print_panel, &panel, sizeof panel);
        begin();
        const enum pel_status status = pel_panel_init(&display, &panel);
        end(status, "init");
        for (int i = 0; status == PEL_OK && i < OPERATIONS; i++) {
            const uint32_t what = random_word(r) % 9;
            if (what < 6 || what == 8) {
                (what < 6 ? flush_any : scroll_any)(r, &display);
                continue;
            }
            begin();
            end(what == 6
                    ? pel_panel_brightness(&panel, (uint8_t)random_word(r))
                    : pel_panel_sleep(&panel, random_word(r) % 2),
                "brightness or sleep");
        }
    }
}

TEST(papers)
{
    static const struct pel_epaper_chip *const papers[] = {
        &pel_epaper_ssd1680,      &pel_epaper_ssd1681,
        &pel_epaper_il3897,       &pel_epaper_uc8151,
        &pel_epaper_uc8179,       &pel_epaper_ssd1680_gray2,
        &pel_epaper_uc8151_gray2, &pel_epaper_uc8179_gray2};
    static const struct pel_format *const formats[] = {&pel_mono1, &pel_inks2,
                                                       &pel_gray2};
    static const uint8_t waveform[] = {3, 0x32, 1, 2, 1, 0x33, 0};
    for (struct cases c = cases_of(3000); cases_next(&c);) {
        struct random *const r = &c.random;
        const struct pel_bus bus = random_bus(r);
        const uint16_t width = (uint16_t)random_between(r, 0, 200),
                       height = (uint16_t)random_between(r, 0, 210);
        uint8_t *const frame =
            calloc(2, (size_t)PEL_EPAPER_FRAME(width, height) + 1);
        struct pel_epaper paper = {.chip = papers[random_word(r) % 8],
                                   .bus = &bus,
                                   .busy = is_busy,
                                   .format = formats[random_word(r) % 3],
                                   .frame = frame,
                                   .width = width,
                                   .height = height,
                                   .rotation = (uint8_t)random_word(r),
                                   .waveform =
                                       random_word(r) % 2 ? waveform : NULL};
        struct pel_display display;
        begin();
        const enum pel_status status = pel_epaper_init(&display, &paper);
        end(status, "init");
        for (int i = 0; status == PEL_OK && i < OPERATIONS; i++) {
            paper.refresh = (uint8_t)(random_word(r) % 4);
            if (random_word(r) % 2)
                flush_any(r, &display);
            else if (random_word(r) % 2)
                flip(&display);
            else {
                begin();
                end(pel_epaper_sleep(&paper), "sleep");
            }
        }
        free(frame);
    }
}

TEST(touch)
{
    static pel_touch_read *const reads[] = {pel_touch_xpt2046_read,
                                            pel_touch_ft6206_read};
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        struct random *const r = &c.random;
        const struct pel_bus bus = random_bus(r);
        struct pel_input events[16], event;
        struct pel_input_queue queue = {.events = events, .size = 16};
        struct pel_touch touch = {.bus = &bus,
                                  .read = reads[random_word(r) % 2]};
        struct pel_touch_pair pairs[3];
        for (int i = 0; i < 3; i++)
            for (int k = 0; k < 2; k++)
                *(k ? &pairs[i].read : &pairs[i].shown) =
                    (struct pel_touch_point){(int16_t)(random_word(r) % 4096),
                                             (int16_t)(random_word(r) % 4096)};
        if (pel_touch_calibrate(&touch.map, pairs, random_between(r, 1, 4096),
                                random_between(r, 1, 4096)) != PEL_OK)
            continue;
        for (int i = 0; i < OPERATIONS; i++) {
            begin();
            end(pel_touch_poll(&touch, (uint32_t)i, &queue), "poll");
            while (random_word(r) % 4 && pel_input_pop(&queue, &event))
                if (event.kind == PEL_INPUT_TOUCH &&
                    (event.x < 0 || event.y < 0 || event.x > 4095 ||
                     event.y > 4095))
                    fail_msg("a finger at %d, %d; %s", event.x, event.y,
                             cases_replay());
        }
    }
    fprintf(stderr, "%llu calls of a bus, bytes that sum up to %u\n",
            (unsigned long long)all_calls, sum);
}
