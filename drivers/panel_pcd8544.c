#include "panel_chip.h"

static const uint8_t setup[] = {
    /* clang-format off */
    7, /* bytes, which may all come at once */
    0x20, /* on */
    0x21, /* the other set of commands */
    0xBF, /* contrast */
    0x04, /* change of voltage with temperature */
    0x14, /* bias 1/48 */
    0x20, /* row by row of bytes, the first set */
    0x0C, /* shows memory */
    0
    /* clang-format on */
};
static const uint8_t wake[] = {1, 0x20, 0};
static const uint8_t sleep[] = {1, 0x24, 0};

/* The chip knows no turns. For those that begin at the end of its memory bytes
 * are copied back to front, and their bits, too. */
static void turn(uint8_t *to, const struct pel_bus_rows *rows)
{
    const int32_t step = rows->count > 1 ? rows->stride : 1;
    for (int32_t i = rows->length * rows->count; i > 0; to++) {
        uint32_t bits = 1; /* the eighth shift moves it out */
        uint32_t byte = rows->bytes[--i * step];
        for (; bits < 256; byte >>= 1)
            bits = bits << 1 | (byte & 1);
        *to = (uint8_t)bits;
    }
}

static enum pel_status page(const struct pel_panel *panel, int32_t row,
                            int32_t column, const struct pel_bus_rows *rows)
{
    const struct pel_bus *bus = panel->bus;
    uint8_t bytes[84];
    const struct pel_bus_rows turned = {bytes, rows->length * rows->count, 1,
                                        0};
    uint8_t place[] = {(uint8_t)(0x40 | row >> 3),
                       (uint8_t)(0x80 + panel->from[0] + column)};
    const bool back = (panel->rotation + 1) & 2;
    if (back) {
        turn(bytes, rows);
        place[0] = 0x40 + 0x40 + 5 - place[0];
        place[1] = (uint8_t)(0x80 + 0x80 + 84 - turned.length - place[1]);
    }
    enum pel_status status = bus->command(bus, place, sizeof place, NULL, 0);
    if (status == PEL_OK)
        status = bus->data(bus, back ? &turned : rows);
    return status == PEL_OK && back && bus->wait ? bus->wait(bus) : status;
}

/* Contrast is a command of the other set, which is left again. */
static enum pel_status command(const struct pel_panel *panel,
                               const uint8_t *list)
{
    const uint8_t contrast[] = {3, 0x21, list[2] | 0x80, 0x20, 0};
    return pel_panel_pages_command(panel, list[1] == 0x21 ? contrast : list);
}

#define PCD8544                                                       \
    .setup = setup, .wake = wake, .sleep = sleep, .command = command, \
    .width = 84, .height = 48, .columns = 84, .page = page,           \
    .turn = {{0x20, 0x20}, {0x20, 0x20}, {0x20, 0x20}, {0x20, 0x20}}, \
    .inversion = 0x0C, .brightness = 0x21, .shift = 1

const struct pel_panel_chip pel_panel_pcd8544 = {
    PCD8544,
    PEL_PANEL_UPRIGHT,
};

const struct pel_panel_chip pel_panel_pcd8544_turned = {
    PCD8544,
    PEL_PANEL_TURNED,
};
