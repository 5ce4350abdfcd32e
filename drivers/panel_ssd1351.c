#include "panel_chip.h"

static const uint8_t setup[] = {
    /* clang-format off */
    2, 0xFD, 0x12, /* opens the commands */
    2, 0xFD, 0xB1, /* and those of the maker */
    1, 0xAE, /* off */
    2, 0xB3, 0xF1, /* clock */
    2, 0xCA, 0x7F, /* 128 rows */
    2, 0xA1, 0x00, /* from row 0 */
    2, 0xA2, 0x00, /* at the top */
    2, 0xB5, 0x00, /* no pins */
    2, 0xAB, 0x01, /* supply of its own */
    2, 0xB1, 0x32, /* times of a row */
    2, 0xBE, 0x05, /* voltages */
    4, 0xC1, 0xC8, 0x80, 0xC8, /* currents of red, green and blue */
    2, 0xC7, 0x0F, /* and of all */
    4, 0xB4, 0xA0, 0xB5, 0x55, /* segment voltage */
    2, 0xB6, 0x01, /* second precharge */
    1, 0xAF, /* on */
    0
    /* clang-format on */
};

/* Coordinates stay those of memory when it is written column by column, so a
 * quarter turn exchanges the commands. Rows run back on the usual module. */
const struct pel_panel_chip pel_panel_ssd1351 = {
    .setup = setup,
    .wake = pel_panel_ssd_wake,
    .sleep = pel_panel_ssd_sleep,
    .command = pel_panel_color_command,
    .send = pel_panel_color_send,
    .width = 128,
    .height = 128,
    .columns = 128,
    PEL_PANEL_565,
    .inversion = 0xA6,
    .brightness = 0xC7,
    .shift = 4,
    .window = {{0x15, 0x75}, {0x75, 0x15}},
    .write = 0x5C,
    .turn = {{0xA0, 0x74}, {0xA0, 0x77}, {0xA0, 0x66}, {0xA0, 0x65}},
    .swap = 0x04,
};
