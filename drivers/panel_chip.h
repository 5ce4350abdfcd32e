/* What a chip of panel.h consists of; for the files of chips.
 *
 * Lists of commands: for each its number of bytes, the command itself among
 * them, and the bytes; 0 ends the list. PEL_PANEL_PAUSE added to the number:
 * 120 ms pass after it; pel_panel_color_command alone takes it. */
#ifndef PEL_DRIVERS_PANEL_CHIP_H
#define PEL_DRIVERS_PANEL_CHIP_H

#include "panel.h"

PEL_BEGIN_DECLS

enum { PEL_PANEL_PAUSE = 0x80 };

/* Ends of lists of MIPI's commands: brightest, by command; out of sleep, on. */
#define PEL_PANEL_BRIGHT 2, 0x51, 0xFF, 2, 0x53, 0x24
#define PEL_PANEL_ON 1 | PEL_PANEL_PAUSE, 0x11, 1, 0x29

struct pel_panel_chip {
    /* Lists of commands, and what sends them. `setup` leaves the panel on. */
    const uint8_t *setup, *wake, *sleep;
    enum pel_status (*command)(const struct pel_panel *panel,
                               const uint8_t *list);

    /* Sends surface->clip, which is on the screen, and not empty. */
    enum pel_status (*send)(const struct pel_panel *panel,
                            const struct pel_surface *surface);

    uint16_t width, height; /* px of the largest glass */
    uint16_t columns;       /* of memory, which has `height` rows */
    uint16_t left;          /* where that glass begins in it */
    uint8_t formats[2];     /* enum pel_format_id, by rotation & 1 */
    uint8_t turn[4][2];     /* two bytes to send, by rotation */
    uint8_t swap;           /* the bit in the second that swaps red and blue */
    uint8_t inversion;      /* command; its lowest bit inverts */
    uint8_t brightness;     /* command of one parameter, */
    uint8_t shift;          /* of so many bits less than 8 */

    /* Of color chips. */
    uint8_t window[2][2]; /* commands for x and y, by rotation & 1 */
    uint8_t write;
    uint8_t wide; /* 1: coordinates have two bytes */

    /* Of monochrome ones: sends rows of bytes from a column of the glass on, to
     * 8 rows of memory from `row` on. */
    enum pel_status (*page)(const struct pel_panel *panel, int32_t row,
                            int32_t column, const struct pel_bus_rows *rows);
};

/* The functions of chips with colors, */
enum pel_status pel_panel_color_command(const struct pel_panel *panel,
                                        const uint8_t *list);
enum pel_status pel_panel_color_send(const struct pel_panel *panel,
                                     const struct pel_surface *surface);

/* of those whose parameters are sent like commands, */
enum pel_status pel_panel_ssd_command(const struct pel_panel *panel,
                                      const uint8_t *list);

/* of monochrome ones in rotations 0 and 2, and in 1 and 3. */
enum pel_status pel_panel_pages_command(const struct pel_panel *panel,
                                        const uint8_t *list);
enum pel_status pel_panel_pages_send(const struct pel_panel *panel,
                                     const struct pel_surface *surface);
enum pel_status pel_panel_page(const struct pel_panel *panel, int32_t row,
                               int32_t column, const struct pel_bus_rows *rows);
enum pel_status pel_panel_turned_send(const struct pel_panel *panel,
                                      const struct pel_surface *surface);

/* The wake and sleep lists of MIPI's Display Command Set, and of Solomon
 * Systech's OLED controllers and those like them. */
extern const uint8_t pel_panel_dcs_wake[], pel_panel_dcs_sleep[];
extern const uint8_t pel_panel_ssd_wake[], pel_panel_ssd_sleep[];

/* Fields that chips have in common: of MIPI's Display Command Set, by the
 * columns of memory, */
#define PEL_PANEL_DCS(n)                                              \
    .wake = pel_panel_dcs_wake, .sleep = pel_panel_dcs_sleep,         \
    .command = pel_panel_color_command, .send = pel_panel_color_send, \
    .width = n, .columns = n, .swap = 0x08,                           \
    .window = {{0x2A, 0x2B}, {0x2A, 0x2B}}, .write = 0x2C, .wide = 1
#define PEL_PANEL_565 .formats = {PEL_FORMAT_RGB565_BE, PEL_FORMAT_RGB565_BE}

/* and monochrome, for half of the rotations; the usual OLED is upside down,
 * which `turn` undoes. */
#define PEL_PANEL_MONO                                                         \
    .wake = pel_panel_ssd_wake, .sleep = pel_panel_ssd_sleep,                  \
    .command = pel_panel_pages_command, .inversion = 0xA6, .brightness = 0x81, \
    .page = pel_panel_page
#define PEL_PANEL_OLED \
    PEL_PANEL_MONO,    \
        .width = 128,  \
        .turn = {{0xA1, 0xC8}, {0xA0, 0xC0}, {0xA0, 0xC0}, {0xA1, 0xC8}}
#define PEL_PANEL_UPRIGHT \
    .send = pel_panel_pages_send, .formats = {PEL_FORMAT_MONO1_PAGES, 0}
#define PEL_PANEL_TURNED \
    .send = pel_panel_turned_send, .formats = {0, PEL_FORMAT_MONO1}
PEL_END_DECLS
#endif
