/* What a panel's wire carries until the first frame is there, and for a step of
 * 32 x 32 pixels: a line for each chip, which panels.sh puts into the manual.
 */
#include <stdio.h>

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

/* I2C has a ninth bit for each byte. */
static double wire_ms(const struct module *m)
{
    return m->megahertz ? bytes / 125.0 / m->megahertz : bytes * 9 / 400.0;
}

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
    static const struct pel_bus bus = {NULL, take_command, take_data,
                                       take_pause, NULL};
    const struct pel_rect step = {0, 0, 32, 32};
    struct pel_panel panel = m->panel;
    struct pel_display display;
    panel.chip = m->object;
    panel.bus = &bus;
    panel.format = m->format;
    bytes = milliseconds = 0;
    if (pel_panel_init(&display, &panel) != PEL_OK)
        return false;
    const double start = milliseconds + wire_ms(m);
    const struct pel_rect whole = {0, 0, display.width, display.height};
    if (!flush(&display, &whole))
        return false;
    const double frame = wire_ms(m);
    if (!flush(&display, &step))
        return false;
    printf("%s\t%s\t", m->chip, m->glass);
    if (m->megahertz)
        printf("%d MHz", m->megahertz);
    else
        printf("I2C");
    printf("\t%.0f\t%.1f\t%.2f\n", start + frame, frame, wire_ms(m));
    return true;
}

int main(void)
{
    for (size_t i = 0; i < sizeof modules / sizeof *modules; i++)
        if (!print(&modules[i])) {
            fprintf(stderr, "panel_times: %s\n", modules[i].chip);
            return 1;
        }
    return 0;
}
