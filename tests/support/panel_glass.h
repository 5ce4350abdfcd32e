/* What the glass of a panel shows after a log of its bus: the panel chips as
 * their data sheets have them, written independently of drivers/. */
#ifndef TESTS_SUPPORT_PANEL_GLASS_H
#define TESTS_SUPPORT_PANEL_GLASS_H

#include "bus_log.h"
#include "core/pel.h"

enum panel_family {
    PANEL_DCS,
    PANEL_SSD1351,
    PANEL_PAGES,  /* SSD1306, SSD1309, SH1106, ST7565 */
    PANEL_SH1107, /* the same, but that pages are of columns of the chip */
    PANEL_PCD8544
};

struct panel_glass {
    /* The chip and how a module is wired to it, set by the test. */
    enum panel_family family;
    int columns, rows;                    /* of memory */
    bool columns_backward, rows_backward; /* glass, against memory as it is
                                             after reset */
    int left, top; /* of the glass, in memory as the glass sees it */

    /* State. */
    bool inverted, on, awake;
    int direction; /* the byte of MADCTL, or A0h */
    int depth;     /* of COLMOD */
    int brightness;
    int command, parameter;
    int x[2], y[2], at[2]; /* window and place, as the chip counts */
    int bytes, pixel;      /* those of a pixel that came, and their value */
    bool segments, scan;   /* A1h, C8h */
    bool extended;         /* the other set of commands of a PCD8544 */
    int multiplex, offset; /* A8h, D3h */
    int scroll[3], start;  /* lines above, of and below those that scroll, 33h;
                              37h */
};

/* Of what memory holds afterwards there is one for all: one glass at a time. */
void panel_glass_reset(struct panel_glass *glass);

/* Takes what came since index `from` of the log; the new end. */
int panel_glass_take(struct panel_glass *glass, const struct bus_log *log,
                     int from);

/* A pixel of the upright glass: 16 bits, or 24 of which the chip has 6 of each
 * channel, or 0 and 1. */
int panel_glass_pixel(const struct panel_glass *glass, int x, int y);

/* Where an upright glass of that size has its pixel `at`, the same in a picture
 * that is turned by so many quarters. */
void panel_glass_turn(int rotation, int width, int height, int at[2]);

/* Does the glass show a turned frame of 24, 16 or 1 bit a pixel, by its bytes?
 * False: not at `at` of the glass. */
bool panel_glass_shows(const struct panel_glass *glass,
                       const struct pel_surface *frame, int rotation,
                       int at[2]);

#endif
