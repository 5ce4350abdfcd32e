#include "panel_chip.h"

/* Parameters go with D/C high. The list may lie on the stack: none of it is in
 * flight in the end. */
enum pel_status pel_panel_color_command(const struct pel_panel *panel,
                                        const uint8_t *list)
{
    const struct pel_bus *bus = panel->bus;
    for (int32_t n; *list; list += n + 1) {
        n = *list & ~PEL_PANEL_PAUSE;
        const struct pel_bus_rows rest = {list + 2, n - 1, 1, 0};
        enum pel_status status = bus->command(bus, list + 1, 1, NULL, 0);
        if (status == PEL_OK && n > 1)
            status = bus->data(bus, &rest);
        if (status == PEL_OK && n != *list)
            status = bus->pause(bus, false, 120);
        if (status != PEL_OK)
            return status;
    }
    return bus->wait ? bus->wait(bus) : PEL_OK;
}

/* Coordinates of the chip, of two bytes or one. */
static uint8_t *add(uint8_t *list, bool wide, int32_t v)
{
    if (wide)
        *list++ = (uint8_t)(v >> 8);
    *list++ = (uint8_t)v;
    return list;
}

static enum pel_status send_window(const struct pel_panel *panel,
                                   const struct pel_rect *a)
{
    const struct pel_panel_chip *chip = panel->chip;
    uint8_t list[16];
    uint8_t *end = list;
    for (int i = 0; i < 2; i++) {
        const int turned = panel->rotation & 1;
        const int32_t from = panel->from[i ^ turned];
        *end++ = chip->wide ? 5 : 3;
        *end++ = chip->window[turned][i];
        end = add(end, chip->wide, from + (i ? a->y0 : a->x0));
        end = add(end, chip->wide, from + (i ? a->y1 : a->x1) - 1);
    }
    *end++ = 1;
    *end++ = chip->write;
    *end = 0;
    return pel_panel_color_command(panel, list);
}

enum pel_status pel_panel_color_send(const struct pel_panel *panel,
                                     const struct pel_surface *surface)
{
    const struct pel_rect *a = &surface->clip;
    enum pel_status status = send_window(panel, a);
    if (status != PEL_OK)
        return status;
    const int32_t bytes = surface->format->bits >> 3;
    struct pel_bus_rows rows = {
        pel_surface_line(surface, a->y0) + bytes * (a->x0 - surface->bounds.x0),
        bytes * (a->x1 - a->x0), a->y1 - a->y0, surface->stride};
    if (rows.length == rows.stride) {
        rows.length *= rows.count;
        rows.count = 1;
    }
    return panel->bus->data(panel->bus, &rows);
}
