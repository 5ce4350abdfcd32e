/* What every screen is made of, in every format (those that differ by the order
 * of their channels alone once): a clear, a rectangle, lines, alpha over one
 * color and over noise, and a line of small text. */
#include <stdio.h>

#include "bench/mcu/report.h"
#include "bench/mcu/stopwatch.h"
#include "core/pel.h"

enum { WIDTH = 128, HEIGHT = 64, LETTERS = 18 };

static uint32_t memory[WIDTH * HEIGHT];
static struct pel_surface surface;
static const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 128, 0));
static const struct pel_flat glass = PEL_FLAT(PEL_RGBA(255, 128, 0, 128));

static struct pel_point at(int32_t x, int32_t y)
{
    return (struct pel_point){PEL_PX(x), PEL_PX(y)};
}

static void clear(void)
{
    pel_clear(&surface, PEL_RGB(20, 90, 160));
}

static void rectangle(void)
{
    pel_rectangle(&surface, at(9, 5), at(109, 55), &flat.paint);
}

/* Flat, steep, and both ways: 208 px. */
static void lines(void)
{
    pel_line(&surface, at(3, 9), at(122, 50), &flat.paint);
    pel_line(&surface, at(50, 3), at(30, 60), &flat.paint);
    pel_line(&surface, at(90, 60), at(60, 31), &flat.paint);
}

static void alpha(void)
{
    pel_rectangle(&surface, at(9, 5), at(73, 55), &glass.paint);
}

/* Capitals of 5 x 7 px in a cell of 6 x 8. */
static void text(void)
{
    static const uint8_t bits[4][7] = {
        {0x70, 0x88, 0x88, 0xF8, 0x88, 0x88, 0x88},
        {0xF0, 0x88, 0x88, 0xF0, 0x88, 0x88, 0xF0},
        {0x70, 0x88, 0x80, 0x80, 0x80, 0x88, 0x70},
        {0xE0, 0x90, 0x88, 0x88, 0x88, 0x90, 0xE0}};
    static const struct pel_font_glyph glyphs[4] = {{0, 5, 7, 0, 7, 6},
                                                    {7, 5, 7, 0, 7, 6},
                                                    {14, 5, 7, 0, 7, 6},
                                                    {21, 5, 7, 0, 7, 6}};
    static const struct pel_font_range range = {'A', 4, 0};
    static const struct pel_font_asset font = {PEL_FONT_MAGIC,
                                               PEL_FONT_VERSION,
                                               7,
                                               1,
                                               1,
                                               4,
                                               PEL_FONT_NONE,
                                               sizeof bits,
                                               &range,
                                               glyphs,
                                               bits[0],
                                               NULL,
                                               NULL,
                                               0,
                                               NULL};
    pel_text(&surface,
             &(struct pel_text_block){&font, "ABCDABCDABCDABCDAB", 5, 5},
             &flat.paint);
}

/* `a` of DejaVu Sans, 16 px from side to side of its em: 9 x 9 px of which 24
 * are clear and 13 full. */
static void smooth_text(void)
{
    static const uint8_t bits[] = {
        0x01, 0x3A, 0xEF, 0x1E, 0xA2, 0x02, 0x47, 0x43, 0x5C, 0xC0, 0x72, 0xF1,
        0x40, 0x28, 0xDE, 0xF3, 0x60, 0x19, 0xE6, 0x32, 0x3F, 0x16, 0x01, 0xF1,
        0x80, 0x32, 0xF1, 0x60, 0x1F, 0x17, 0x03, 0x7F, 0x16, 0x01, 0xBD, 0x20,
        0x15, 0xEF, 0x16, 0x01, 0x1B, 0xF1, 0xEB, 0x4F, 0x16};
    static const struct pel_font_glyph glyph = {0, 9, 9, 0, 9, 10};
    static const struct pel_font_range range = {'a', 1, 0};
    static const struct pel_font_asset font = {.magic = PEL_FONT_MAGIC,
                                               .version = PEL_FONT_VERSION,
                                               .ascent = 15,
                                               .descent = 4,
                                               .ranges = 1,
                                               .glyphs = 1,
                                               .missing = PEL_FONT_NONE,
                                               .size = sizeof bits,
                                               .range = &range,
                                               .glyph = &glyph,
                                               .bits = bits,
                                               .kind = &pel_font_smooth};
    pel_text(&surface, &(struct pel_text_block){&font, "aaaaaaaaaa", 5, 5},
             &flat.paint);
}

static void noise(void)
{
    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++)
        memory[i] = i * 2654435761u;
}

static void case_report(const char *what, const char *format,
                        void (*draw)(void), int32_t pixels)
{
    char name[40];
    snprintf(name, sizeof name, "%s-%s", what, format);
    const uint32_t from = stopwatch_read();
    draw();
    report(name, pixels, stopwatch_eighths(from, stopwatch_read()), 1);
}

void fills_report(void)
{
    static const struct {
        const char *name;
        const struct pel_format *format;
    } formats[] = {{"rgb565_le", &pel_rgb565_le},
                   {"rgb565_be", &pel_rgb565_be},
                   {"rgb888", &pel_rgb888},
                   {"xrgb8888", &pel_xrgb8888},
                   {"rgbx8888", &pel_rgbx8888},
                   {"argb8888", &pel_argb8888},
                   {"xrgb1555_le", &pel_xrgb1555_le},
                   {"rgb332", &pel_rgb332},
                   {"gray8", &pel_gray8},
                   {"gray4", &pel_gray4},
                   {"inks2", &pel_inks2},
                   {"gray2", &pel_gray2},
                   {"mono1", &pel_mono1},
                   {"mono1_pages", &pel_mono1_pages}};
    const struct pel_rect bounds = {0, 0, WIDTH, HEIGHT};
    for (unsigned i = 0; i < sizeof formats / sizeof *formats; i++) {
        const char *const name = formats[i].name;
        pel_surface_init(&surface, formats[i].format, memory, sizeof memory,
                         &bounds);
        noise();
        case_report("alpha-noise", name, alpha, 64 * 50);
        case_report("clear", name, clear, WIDTH * HEIGHT);
        case_report("alpha-even", name, alpha, 64 * 50);
        case_report("box", name, rectangle, 100 * 50);
        case_report("lines", name, lines, 208);
        case_report("letters", name, text, LETTERS);
        case_report("smooth-letters", name, smooth_text, 10);
    }
}
