/* Panels behind a bus (bus.h): one const object for each controller chip, one
 * struct that says what a module makes of it, and a display for both.
 *
 *     static struct pel_panel panel = {.chip = &pel_panel_st7789,
 *                                      .bus = &bus,
 *                                      .format = &pel_rgb565_be,
 *                                      PEL_PANEL_135X240,
 *                                      .rotation = 1};
 *     struct pel_display display;
 *     if (pel_panel_init(&display, &panel) != PEL_OK)
 *         ...the bus has said what went wrong...
 *
 * flush sends surface->clip as it lies in memory: no copy, no swap of bytes.
 * Where `data` of the bus returns early, so does flush, and `wait` of the
 * display is that of the bus. A clip that leaves the screen is
 * PEL_ERROR_SIZE.
 *
 * Color panels take pel_rgb565_be (or its _fill variant), an ILI9488
 * pel_bgr888, of which it leaves two bits a channel out, and any window.
 *
 * Monochrome ones hold 8 rows in a byte. Upright they take pel_mono1_pages and
 * windows whose rows are multiples of 8, turned pel_mono1 and windows whose
 * columns are. Those of 16 greys take pel_gray4 and windows whose columns are
 * even. pel_display_align makes them so; any other is PEL_ERROR_SIZE. */
#ifndef PEL_DRIVERS_PANEL_H
#define PEL_DRIVERS_PANEL_H

#include "bus.h"
#include "display.h"

PEL_BEGIN_DECLS

struct pel_panel {
    /* The program's. What is left 0 is what most modules have. */
    const struct pel_panel_chip *chip;
    const struct pel_bus *bus;
    const struct pel_format *format;
    uint16_t width, height; /* px of the glass in rotation 0; 0: the chip's */
    uint16_t left, top;     /* where it begins on the chip's largest glass */
    uint8_t rotation;       /* of the picture: quarter turns clockwise, mod 4 */
    bool inverted;          /* light and dark, other than most modules */
    bool swapped;           /* red and blue, other than most modules */

    int32_t from[2]; /* set by init: first column and row of memory in use */
};

/* Glass of an ST7789 that is smaller than its memory, for designated
 * initialisers. */
#define PEL_PANEL_240X240 .width = 240, .height = 240
#define PEL_PANEL_135X240 .width = 135, .height = 240, .left = 52, .top = 40
#define PEL_PANEL_170X320 .width = 170, .height = 320, .left = 35
#define PEL_PANEL_240X280 .width = 240, .height = 280, .top = 20
/* Glass of an ST7735 with its largest memory, or with one of 132x132. */
#define PEL_PANEL_128X160 .width = 128, .height = 160, .left = 2, .top = 1
#define PEL_PANEL_80X160 .width = 80, .height = 160, .left = 26, .top = 1
#define PEL_PANEL_128X128 .width = 128, .height = 128, .left = 2, .top = 3

/* Color panels; in brackets, a module that the values of the file are meant
 * for. */
extern const struct pel_panel_chip pel_panel_st7789;  /* 240x320 */
extern const struct pel_panel_chip pel_panel_ili9341; /* 240x320 (MSP2807) */
extern const struct pel_panel_chip pel_panel_ili9342; /* 320x240, ILI9342C
                                                         (M5Stack Core) */
extern const struct pel_panel_chip pel_panel_ili9488; /* 320x480 (MSP3520) */
extern const struct pel_panel_chip pel_panel_st7796;  /* 320x480 (MSP4021) */
extern const struct pel_panel_chip pel_panel_gc9a01;  /* 240x240, round */
extern const struct pel_panel_chip pel_panel_ssd1351; /* 128x128, OLED */

/* ST7735R and S by their memory, which pins of the chip decide. Modules with a
 * green tab have all of it, also those of 80x160; those with a black tab have
 * 128x160, where glass of 80x160 begins at column 24; those of 128x128 have
 * 132x132. If the picture is 2 columns and a row aside, it is the other one. */
extern const struct pel_panel_chip pel_panel_st7735; /* 132x162 */
extern const struct pel_panel_chip pel_panel_st7735_128x160;
extern const struct pel_panel_chip pel_panel_st7735_132x132;

/* Monochrome OLEDs, for rotations 0 and 2, and for 1 and 3. */
extern const struct pel_panel_chip pel_panel_ssd1306; /* 128x64 */
extern const struct pel_panel_chip pel_panel_ssd1306_turned;
extern const struct pel_panel_chip pel_panel_ssd1306_32; /* 128x32 */
extern const struct pel_panel_chip pel_panel_ssd1306_32_turned;
extern const struct pel_panel_chip pel_panel_ssd1309; /* 128x64 */
extern const struct pel_panel_chip pel_panel_ssd1309_turned;
extern const struct pel_panel_chip pel_panel_sh1106; /* 128x64 */
extern const struct pel_panel_chip pel_panel_sh1106_turned;
extern const struct pel_panel_chip pel_panel_sh1107; /* 64x128 */
extern const struct pel_panel_chip pel_panel_sh1107_turned;
extern const struct pel_panel_chip pel_panel_sh1107_128; /* 128x128 */
extern const struct pel_panel_chip pel_panel_sh1107_128_turned;

/* Monochrome LCDs, in the same way; their brightness is the contrast. The
 * PCD8544 knows no turns: in rotations 1 and 2 flush sends copies, and is done
 * when it returns. Brightness wakes it. */
extern const struct pel_panel_chip pel_panel_st7565; /* 128x64 (EA DOGM128-6) */
extern const struct pel_panel_chip pel_panel_st7565_turned;
extern const struct pel_panel_chip pel_panel_pcd8544; /* 84x48 (Nokia 5110) */
extern const struct pel_panel_chip pel_panel_pcd8544_turned;

/* OLEDs of 16 greys, upright and not inverted, others are PEL_ERROR_FORMAT. */
extern const struct pel_panel_chip pel_panel_ssd0323; /* 128x64 */

/* Resets and sets up the chip, 0.4 s at most; then the panel is on, and shows
 * what its memory held. `panel` becomes the context of `display`, and both stay
 * the caller's. PEL_ERROR_NULL, for a bus without `data` too; PEL_ERROR_SIZE
 * when the glass is not inside the chip's memory, or, after the reset, when it
 * begins or ends within one of its bytes (8 rows of a monochrome chip, 2
 * columns of 16 greys); PEL_ERROR_FORMAT, also for a chip of the other
 * rotations; or what the bus said. */
enum pel_status pel_panel_init(struct pel_display *display,
                               struct pel_panel *panel);

/* 0 (dark, or nearly) to 255; init leaves what most modules want. Nothing is
 * seen of it where a module's backlight is not wired to the chip. */
enum pel_status pel_panel_brightness(const struct pel_panel *panel,
                                     uint8_t level);

/* Off and on again, 120 ms each for color LCDs; memory keeps its pixels. */
enum pel_status pel_panel_sleep(const struct pel_panel *panel, bool asleep);
PEL_END_DECLS
#endif
