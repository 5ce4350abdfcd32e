/* What a panel's wire carries until the first frame is there, and for a step of
 * 32 x 32 pixels: a line for each chip, which panels.sh puts into the manual.
 * The same of e-paper, whose chip is never busy here. */
#include <stdio.h>

#include "drivers/epaper.h"
#include "drivers/epaper_chip.h"
#include "drivers/panel.h"

static const struct module {
    const char *chip, *glass; /* written for */
    const struct pel_panel_chip *object;
    const struct pel_format *format;
    int megahertz; /* of the SPI of usual modules; 0: I2C at 400 kHz */
    struct pel_panel panel;
} modules[] = {
#define WHOLE .rotation = 0
#define MODULE(chip, glass, format, megahertz, ...) \
    {#chip, glass, &pel_panel_##chip, &pel_##format, megahertz, {__VA_ARGS__}},
    MODULE(st7789, "240x320; 240x240, 135x240, 170x320, 240x280 IPS", rgb565_be,
           40, WHOLE) MODULE(st7735,
                             "128x160 and 160x80 TFT of ST7735R and S; 128x128",
                             rgb565_be, 16,
                             PEL_PANEL_128X160) MODULE(st7796,
                                                       "320x480 TFT (MSP4021)",
                                                       rgb565_be, 40, WHOLE)
        MODULE(ili9341, "240x320 TFT (MSP2807)", rgb565_be, 40, WHOLE) MODULE(
            ili9342, "320x240 IPS of ILI9342C (M5Stack)", rgb565_be, 40,
            WHOLE) MODULE(ili9488, "320x480 TFT (MSP3520), 3 bytes a pixel",
                          bgr888, 40, WHOLE) MODULE(gc9a01, "240x240 round IPS",
                                                    rgb565_be, 40, WHOLE)
            MODULE(ssd1351, "128x128, 128x96 OLED", rgb565_be, 16, WHOLE)
                MODULE(ssd1306, "128x64, 128x32, 72x40 OLED", mono1_pages, 0,
                       WHOLE) MODULE(ssd1309, "128x64 OLED of 2.4 inches",
                                     mono1_pages, 8, WHOLE)
                    MODULE(sh1106, "128x64 OLED of 1.3 inches", mono1_pages, 0,
                           WHOLE) MODULE(sh1107, "64x128, 128x128 OLED",
                                         mono1_pages, 0, WHOLE)
                        MODULE(st7565, "128x64 LCD (EA DOGM128-6)", mono1_pages,
                               8, WHOLE)
                            MODULE(pcd8544, "84x48 LCD (Nokia 5110)",
                                   mono1_pages, 4, WHOLE)
                                MODULE(ssd0323,
                                       "128x64 OLED of 16 greys, not turned",
                                       gray4, 8, WHOLE)};

enum { PAPER_MEGAHERTZ = 4 };

static uint8_t memory[320 * 480 * 3];
static uint32_t bytes, milliseconds;

static enum pel_status take_command(const struct pel_bus *bus,
                                    const uint8_t *sent, size_t n,
                                    uint8_t *answer, size_t answers)
{
    (void)bus, (void)sent, (void)answer, (void)answers;
    bytes += (uint32_t)n;
    return PEL_OK;
}

static enum pel_status take_data(const struct pel_bus *bus,
                                 const struct pel_bus_rows *rows)
{
    (void)bus;
    bytes += (uint32_t)(rows->length * rows->count);
    return PEL_OK;
}

static enum pel_status take_pause(const struct pel_bus *bus, bool reset,
                                  uint32_t ms)
{
    (void)bus, (void)reset;
    milliseconds += ms;
    return PEL_OK;
}

/* 0: I2C at 400 kHz, which has a ninth bit for each byte. */
static double wire_ms(int megahertz)
{
    return megahertz ? bytes / 125.0 / megahertz : bytes * 9 / 400.0;
}

static const struct pel_bus bus = {NULL, take_command, take_data, take_pause,
                                   NULL};

static bool flush(const struct pel_display *display,
                  const struct pel_rect *area)
{
    struct pel_surface s;
    bytes = 0;
    return pel_surface_init(&s, display->format, memory, sizeof memory, area) ==
               PEL_OK &&
           pel_display_flush(display, &s) == PEL_OK;
}

static bool print(const struct module *m)
{
    const struct pel_rect step = {0, 0, 32, 32};
    struct pel_panel panel = m->panel;
    struct pel_display display;
    panel.chip = m->object;
    panel.bus = &bus;
    panel.format = m->format;
    bytes = milliseconds = 0;
    if (pel_panel_init(&display, &panel) != PEL_OK)
        return false;
    const double start = milliseconds + wire_ms(m->megahertz);
    const struct pel_rect whole = {0, 0, display.width, display.height};
    if (!flush(&display, &whole))
        return false;
    const double frame = wire_ms(m->megahertz);
    if (!flush(&display, &step))
        return false;
    printf("%s\t%s\t", m->chip, m->glass);
    if (m->megahertz)
        printf("%d MHz", m->megahertz);
    else
        printf("I2C");
    printf("\t%.0f\t%.1f\t%.2f\n", start + frame, frame, wire_ms(m->megahertz));
    return true;
}

static const struct paper {
    const char *chip;
    const struct pel_epaper_chip *object;
    const struct pel_format *format;
    uint16_t width, height;
    uint8_t step; /* the refresh of a step */
} papers[] = {
#define PAPER(chip, format, width, height, step)                 \
    {                                                            \
#chip, &pel_epaper_##chip, &pel_##format, width, height, \
            PEL_EPAPER_##step                                    \
    }
    PAPER(ssd1680, mono1, 122, 250, PARTIAL),
    PAPER(ssd1681, mono1, 200, 200, PARTIAL),
    PAPER(il3897, mono1, 122, 250, PARTIAL),
    PAPER(uc8151, mono1, 128, 296, PARTIAL),
    PAPER(uc8179, mono1, 800, 480, PARTIAL),
    PAPER(ssd1680_gray2, gray2, 122, 250, FULL),
    PAPER(uc8151_gray2, gray2, 128, 296, FULL),
    PAPER(uc8179_gray2, gray2, 800, 480, FULL),
};

static bool never_busy(const struct pel_epaper *paper)
{
    return !paper->chip->busy;
}

/* ms until the chip begins to refresh the glass. */
static bool refresh_ms(const struct pel_display *display, double *ms)
{
    const struct pel_rect step = {0, 0, 32, 32};
    if (!flush(display, &step) || pel_display_flip(display) != PEL_OK)
        return false;
    *ms = milliseconds + wire_ms(PAPER_MEGAHERTZ);
    milliseconds = 0;
    return true;
}

static bool print_paper(const struct paper *p)
{
    static uint8_t frame[2 * PEL_EPAPER_FRAME(800, 480)];
    struct pel_epaper paper = {.chip = p->object,
                               .bus = &bus,
                               .busy = never_busy,
                               .format = p->format,
                               .frame = frame,
                               .width = p->width,
                               .height = p->height};
    struct pel_display display;
    double first, step;
    bytes = milliseconds = 0;
    if (pel_epaper_init(&display, &paper) != PEL_OK)
        return false;
    const double start = wire_ms(PAPER_MEGAHERTZ);
    if (!refresh_ms(&display, &first))
        return false;
    paper.refresh = p->step;
    if (!refresh_ms(&display, &step))
        return false;
    printf("epaper_%s\t%.0f\t%.0f\n", p->chip, start + first, step);
    return true;
}

static int failed(const char *chip)
{
    fprintf(stderr, "panel_times: %s\n", chip);
    return 1;
}

int main(void)
{
    for (size_t i = 0; i < sizeof modules / sizeof *modules; i++)
        if (!print(&modules[i]))
            return failed(modules[i].chip);
    for (size_t i = 0; i < sizeof papers / sizeof *papers; i++)
        if (!print_paper(&papers[i]))
            return failed(papers[i].chip);
    return 0;
}
