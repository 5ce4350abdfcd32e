#include "panel_chip.h"

/* OLEDs of 16 greys. A byte is a column of memory and two pixels, the left one
 * in its high half. Parameters are sent like commands. */
static const uint8_t setup[] = {
    19,   0xAE, 0xB3, 0x91, /* bytes that may come at once; off; clock */
    0xA8, 0x3F, 0xA1, 0x00, 0xA2, 0x40, /* 64 rows, from row 0 of memory's 80 */
    0xAD, 0x02, 0x86, /* supply of the module's; full current */
    0xB1, 0x55, 0xBC, 0x10, 0xBE, 0x1C, /* times of a row; voltages */
    0xAF, 0                             /* on */
};

/* Other turns and inversion need more registers than panel.c sets. Glass that
 * ends within a byte is refused, too. */
static enum pel_status command(const struct pel_panel *panel,
                               const uint8_t *list)
{
    if (panel->rotation & 3 || panel->inverted)
        return PEL_ERROR_FORMAT;
    return (panel->from[0] | panel->width) & 1
               ? PEL_ERROR_SIZE
               : pel_panel_ssd_command(panel, list);
}

static enum pel_status send(const struct pel_panel *panel,
                            const struct pel_surface *surface)
{
    const struct pel_rect *a = &surface->clip;
    const struct pel_bus_rows rows = {
        pel_surface_line(surface, a->y0) + (a->x0 - surface->bounds.x0) / 2,
        (a->x1 - a->x0) / 2, a->y1 - a->y0, surface->stride};
    const uint8_t left = (uint8_t)((panel->from[0] + a->x0) / 2);
    const uint8_t top = (uint8_t)(panel->from[1] + a->y0);
    const uint8_t right = (uint8_t)(left + rows.length - 1);
    const uint8_t below = (uint8_t)(top + rows.count - 1);
    const uint8_t list[] = {6, 0x15, left, right, 0x75, top, below, 0};
    enum pel_status status =
        (a->x0 | a->x1) & 1 ? PEL_ERROR_SIZE : command(panel, list);
    return status == PEL_OK ? panel->bus->data(panel->bus, &rows) : status;
}

const struct pel_panel_chip pel_panel_ssd0323 = {
    .setup = setup,
    .wake = pel_panel_ssd_wake,
    .sleep = pel_panel_ssd_sleep,
    .command = command,
    .send = send,
    .width = 128,
    .height = 64,
    .columns = 128,
    .formats[0] = PEL_FORMAT_GRAY4,
    .turn[0] = {0xA0, 0x52},
    .inversion = 0xA4,
    .brightness = 0x81,
    .shift = 1,
};
