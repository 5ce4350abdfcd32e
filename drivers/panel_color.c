#include "panel_chip.h"

/* Parameters go with D/C high, and are on the stack perhaps. */
static enum pel_status send_command(const struct pel_panel *panel,
                                    const uint8_t *bytes, int32_t n)
{
    const struct pel_bus *bus = panel->bus;
    const struct pel_bus_rows rest = {bytes + 1, n - 1, 1, 0};
    enum pel_status status = bus->command(bus, bytes, 1, NULL, 0);
    if (status == PEL_OK && rest.length)
        status = bus->data(bus, &rest);
    return status == PEL_OK && bus->wait ? bus->wait(bus) : status;
}

enum pel_status pel_panel_color_command(const struct pel_panel *panel,
                                        const uint8_t *list)
{
    enum pel_status status = PEL_OK;
    for (int32_t n; *list && status == PEL_OK; list += n + 1) {
        n = *list & ~PEL_PANEL_PAUSE;
        status = send_command(panel, list + 1, n);
        if (status == PEL_OK && n != *list)
            status = panel->bus->pause(panel->bus, false, 120);
    }
    return status;
}

/* Adds a command whose parameters are coordinates of the chip, the first and
 * the last one of [from, to), to a list. */
static uint8_t *add_range(uint8_t *list, bool wide, uint8_t command,
                          int32_t from, int32_t to)
{
    const int32_t ends[2] = {from, to - 1};
    *list++ = wide ? 5 : 3;
    *list++ = command;
    for (int i = 0; i < 2; i++) {
        if (wide)
            *list++ = (uint8_t)(ends[i] >> 8);
        *list++ = (uint8_t)ends[i];
    }
    return list;
}

static enum pel_status send_window(const struct pel_panel *panel,
                                   const struct pel_rect *a)
{
    const struct pel_panel_chip *chip = panel->chip;
    const int turned = panel->rotation & 1;
    const int32_t x = panel->from[turned], y = panel->from[!turned];
    const uint8_t *command = chip->window[turned];
    uint8_t list[16];
    uint8_t *end = list;
    end = add_range(end, chip->wide, command[0], a->x0 + x, a->x1 + x);
    end = add_range(end, chip->wide, command[1], a->y0 + y, a->y1 + y);
    *end++ = 1;
    *end++ = chip->write;
    *end = 0;
    return pel_panel_color_command(panel, list);
}

enum pel_status pel_panel_color_send(const struct pel_panel *panel,
                                     const struct pel_surface *surface)
{
    const struct pel_rect *a = &surface->clip;
    struct pel_bus_rows rows = {
        pel_surface_line(surface, a->y0) + 2 * (a->x0 - surface->bounds.x0),
        2 * (a->x1 - a->x0), a->y1 - a->y0, surface->stride};
    if (rows.length == rows.stride) {
        rows.length *= rows.count;
        rows.count = 1;
    }
    enum pel_status status = send_window(panel, a);
    return status == PEL_OK ? panel->bus->data(panel->bus, &rows) : status;
}
