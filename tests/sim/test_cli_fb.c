/* Framebuffers whose ioctls are answered here, over a file: each pixel of the
 * device shows the one that was drawn, turned or not, in every layout, also
 * those of 1 and 2 bits, which the kernel's own test device lacks. */
#include "tests/support/check.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "drivers/display_linux_fb.h"
#include "tests/support/cases.h"

enum { LINES = 23, MOST = 64 * LINES * 4 };

static struct pel_fb_mode mode;
static uint16_t map[3][PEL_FB_COLORS];
static uint32_t map_length;

/* Instead of that of libc. */
int ioctl(int fd, unsigned long request, ...)
{
    va_list rest;
    va_start(rest, request);
    void *const argument = va_arg(rest, void *);
    va_end(rest);
    (void)fd;
    if (request == FBIOGET_VSCREENINFO) {
        memcpy(argument, &mode.variable, sizeof mode.variable);
    } else if (request == FBIOGET_FSCREENINFO) {
        memcpy(argument, &mode.fixed, sizeof mode.fixed);
    } else if (request == FBIOPUTCMAP) {
        const struct fb_cmap *const c = argument;
        map_length = c->len;
        memcpy(map[0], c->red, c->len * sizeof(uint16_t));
        memcpy(map[1], c->green, c->len * sizeof(uint16_t));
        memcpy(map[2], c->blue, c->len * sizeof(uint16_t));
    } else {
        errno = ENOTTY;
        return -1;
    }
    return 0;
}

struct layout {
    const char *name;
    const struct pel_format *format;
    uint32_t bits, visual, gray;
    uint32_t channels[6]; /* offset, length of red, green, blue */
};

#define FEW(bits)                 \
    {                             \
        0, bits, 0, bits, 0, bits \
    }
static const struct layout layouts[] = {
    {"1 bit, 1 black", &pel_mono1, 1, FB_VISUAL_MONO01, 0, FEW(1)},
    {"1 bit, 1 white", &pel_mono1, 1, FB_VISUAL_MONO10, 0, FEW(1)},
    {"1 bit, palette", &pel_mono1, 1, FB_VISUAL_PSEUDOCOLOR, 0, FEW(1)},
    {"2 bits, 3 black", &pel_gray8, 2, FB_VISUAL_MONO01, 0, FEW(2)},
    {"2 bits, 3 white", &pel_gray8, 2, FB_VISUAL_MONO10, 0, FEW(2)},
    {"2 bits, palette", &pel_gray8, 2, FB_VISUAL_PSEUDOCOLOR, 0, FEW(2)},
    {"2 bits, grey", &pel_gray8, 2, FB_VISUAL_STATIC_PSEUDOCOLOR, 1, FEW(2)},
    {"grey", &pel_gray8, 8, FB_VISUAL_STATIC_PSEUDOCOLOR, 1, FEW(8)},
    {"332", &pel_rgb332, 8, FB_VISUAL_TRUECOLOR, 0, {5, 3, 2, 3, 0, 2}},
    {"565", &pel_rgb565_le, 16, FB_VISUAL_TRUECOLOR, 0, {11, 5, 5, 6, 0, 5}},
    {"888", &pel_rgb888, 24, FB_VISUAL_TRUECOLOR, 0, {16, 8, 8, 8, 0, 8}},
    {"8888", &pel_xrgb8888, 32, FB_VISUAL_TRUECOLOR, 0, {16, 8, 8, 8, 0, 8}}};
enum { LAYOUTS = sizeof layouts / sizeof *layouts };

/* A mode whose lines are padded to 4 bytes. */
static void set_mode(const struct layout *l, uint32_t width)
{
    struct fb_var_screeninfo *const v = &mode.variable;
    memset(&mode, 0, sizeof mode);
    v->xres = v->xres_virtual = width;
    v->yres = v->yres_virtual = LINES;
    v->bits_per_pixel = l->bits;
    v->grayscale = l->gray;
    v->red = (struct fb_bitfield){l->channels[0], l->channels[1], 0};
    v->green = (struct fb_bitfield){l->channels[2], l->channels[3], 0};
    v->blue = (struct fb_bitfield){l->channels[4], l->channels[5], 0};
    mode.fixed.visual = l->visual;
    mode.fixed.line_length = (width * l->bits + 31) / 32 * 4;
    mode.fixed.smem_len = mode.fixed.line_length * LINES;
    map_length = 0;
}

/* The value at a pixel of the device, the first in the low bits. */
static uint32_t device_at(const uint8_t *bytes, int32_t x, int32_t y)
{
    const uint32_t bits = mode.variable.bits_per_pixel;
    const uint8_t *const line = bytes + (uint32_t)y * mode.fixed.line_length;
    uint32_t value = 0;
    for (uint32_t k = 0; k < bits; k++) {
        const uint32_t bit = (uint32_t)x * bits + k;
        value |= (uint32_t)(line[bit / 8] >> bit % 8 & 1) << k;
    }
    return value;
}

/* The same as a color, of formats of more than 2 bits. */
static uint32_t shown_at(const struct layout *l, const uint8_t *bytes,
                         struct pel_point at)
{
    const uint32_t value = device_at(bytes, at.x, at.y);
    return l->bits > 2 ? l->format->unpack(value) : value;
}

/* What it should be for a color of the frame. */
static uint32_t expected(const struct layout *l, pel_color color)
{
    const uint32_t last = (1u << l->bits % 32) - 1;
    if (l->bits > 2)
        return color; /* unpacked */
    const uint32_t level = pel_gray(color) >> (8 - l->bits);
    return l->visual == FB_VISUAL_MONO01 ? last - level : level;
}

/* Brings a pixel of the frame to the device, quarter by quarter. */
static struct pel_point turn(struct pel_point p, int32_t turns, int32_t height)
{
    const int32_t width = (int32_t)mode.variable.xres;
    int32_t high = height;
    for (; turns > 0; turns--) {
        p = (struct pel_point){high - 1 - p.y, p.x};
        high = high == LINES ? width : LINES;
    }
    return p;
}

static void check_device(const struct layout *l, int fd, int32_t turns,
                         const struct pel_surface *frame)
{
    static uint8_t bytes[MOST];
    assert_int_equal(pread(fd, bytes, mode.fixed.smem_len, 0),
                     mode.fixed.smem_len);
    for (int32_t y = 0; y < frame->bounds.y1; y++)
        for (int32_t x = 0; x < frame->bounds.x1; x++) {
            const struct pel_point at =
                turn((struct pel_point){x, y}, turns, frame->bounds.y1);
            pel_color color;
            frame->format->load(frame, x, y, 1, &color);
            if (shown_at(l, bytes, at) != expected(l, color))
                fail_msg("%s, %d turns, %u px wide: (%d, %d) at (%d, %d) is "
                         "%x, not %x; %s",
                         l->name, turns, mode.variable.xres, x, y, at.x, at.y,
                         (unsigned)shown_at(l, bytes, at),
                         (unsigned)expected(l, color), cases_replay());
        }
}

static void draw_part(struct random *r, const struct pel_display *display,
                      struct pel_surface *s)
{
    const struct pel_rect part = {random_between(r, -3, display->width),
                                  random_between(r, -3, display->height),
                                  random_between(r, 0, display->width + 3),
                                  random_between(r, 0, display->height + 3)};
    assert_int_equal(pel_display_begin(display, &part, s), PEL_OK);
    for (int32_t y = s->clip.y0; y < s->clip.y1; y++)
        for (int32_t x = s->clip.x0; x < s->clip.x1; x++) {
            const pel_color color = random_word(r) | 0xFF000000;
            s->format->put(s, x, y, 1, &color);
        }
    assert_int_equal(pel_display_flush(display, s), PEL_OK);
}

TEST(pixels)
{
    char path[] = "/tmp/pel-fb-XXXXXX";
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    assert_int_equal(ftruncate(fd, MOST), 0);
    for (struct cases c = cases_of(2000); cases_next(&c);) {
        struct random *const r = &c.random;
        const struct layout *const l = &layouts[random_word(r) % LAYOUTS];
        const int32_t turns = (int32_t)(random_word(r) % 4);
        struct pel_display_fb fb;
        struct pel_display display;
        struct pel_surface frame;
        struct pel_message message;
        set_mode(l, 1 + random_word(r) % 64);
        assert_int_equal(pel_display_fb_open(&fb, path, &message), 0);
        assert_int_equal(
            pel_display_fb_start(&display, &fb, PEL_FB_SHADOW, turns), 0);
        assert_ptr_equal(display.format, l->format);
        assert_int_equal(display.width,
                         turns % 2 ? LINES : (int)mode.variable.xres);
        const struct pel_rect all = {0, 0, display.width, display.height};
        assert_int_equal(pel_display_begin(&display, &all, &frame), PEL_OK);
        assert_int_equal(pel_display_flush(&display, &frame), PEL_OK);
        for (int i = 0; i < 3; i++) {
            draw_part(r, &display, &frame);
            draw_part(r, &display, &frame);
            assert_int_equal(pel_display_flip(&display), PEL_OK);
            check_device(l, fd, turns, &frame);
        }
        pel_display_fb_close(&fb);
    }
    close(fd);
    unlink(path);
}

TEST(greys_of_palettes)
{
    for (size_t i = 0; i < LAYOUTS; i++) {
        const struct layout *const l = &layouts[i];
        struct pel_message message;
        uint16_t greys[3][PEL_FB_COLORS];
        set_mode(l, 8);
        if (l->bits > 2)
            continue;
        const uint32_t n =
            pel_fb_color_map(&mode, pel_fb_format(&mode, &message), greys);
        assert_int_equal(n,
                         l->visual == FB_VISUAL_PSEUDOCOLOR ? 1 << l->bits : 0);
        for (uint32_t k = 0; k < n; k++)
            for (int c = 0; c < 3; c++)
                assert_int_equal(greys[c][k], 65535 * k / (n - 1));
    }
}

/* What is turned, or of few bits, needs the shadow; by itself it has it. */
TEST(ways)
{
    char path[] = "/tmp/pel-fb-XXXXXX";
    const int file = mkstemp(path);
    assert_int_equal(ftruncate(file, MOST), 0);
    for (int i = 0; i < 2; i++)
        for (int32_t turns = 0; turns < 2; turns++)
            for (int way = PEL_FB_ANY; way <= PEL_FB_DIRECT; way++) {
                struct pel_display_fb fb;
                struct pel_display display;
                struct pel_message message;
                const bool copied = i == 0 || turns != 0;
                set_mode(&layouts[i ? LAYOUTS - 1 : 0], 40);
                assert_int_equal(pel_display_fb_open(&fb, path, &message), 0);
                const int error = pel_display_fb_start(
                    &display, &fb, (enum pel_fb_way)way, turns);
                const bool named = way == PEL_FB_PAGES || way == PEL_FB_DIRECT;
                assert_int_equal(error != 0,
                                 (copied && named) || way == PEL_FB_PAGES);
                if (!error && copied)
                    assert_int_equal(fb.way, PEL_FB_SHADOW);
                if (!error)
                    assert_int_equal(display.width, turns ? LINES : 40);
                pel_display_fb_close(&fb);
            }
    close(file);
    unlink(path);
}

/* Channels say more than the bits that a driver tells. */
TEST(bits_that_are_told_wrong)
{
    char path[] = "/tmp/pel-fb-XXXXXX";
    const int fd = mkstemp(path);
    struct pel_display_fb fb;
    struct pel_display display;
    struct pel_message message;
    assert_int_equal(ftruncate(fd, MOST), 0);
    set_mode(&layouts[9], 40);
    assert_ptr_equal(layouts[9].format, &pel_rgb565_le);
    mode.variable.bits_per_pixel = 2;
    assert_int_equal(pel_display_fb_open(&fb, path, &message), 0);
    assert_int_equal(pel_display_fb_start(&display, &fb, PEL_FB_ANY, 1), 0);
    assert_ptr_equal(display.format, &pel_rgb565_le);
    assert_int_equal(fb.memory.bits, 16);
    pel_display_fb_close(&fb);
    close(fd);
    unlink(path);
}
