#include "panel_chip.h"

/* Monochrome chips. Memory is in pages of 8 rows, a byte for each column, the
 * top row in its lowest bit. */

/* Glass that ends within a page is refused before the first command. */
enum pel_status pel_panel_pages_command(const struct pel_panel *panel,
                                        const uint8_t *list)
{
    return (panel->from[1] | panel->height) & 7
               ? PEL_ERROR_SIZE
               : pel_panel_ssd_command(panel, list);
}

enum pel_status pel_panel_page(const struct pel_panel *panel, int32_t row,
                               int32_t column, const struct pel_bus_rows *rows)
{
    const uint32_t at = (uint32_t)(panel->from[0] + column);
    const struct pel_bus *bus = panel->bus;
    const uint8_t place[] = {(uint8_t)(0xB0 + (uint32_t)row / 8),
                             (uint8_t)(0x10 + at / 16), at & 15};
    enum pel_status status = bus->command(bus, place, sizeof place, NULL, 0);
    return status == PEL_OK ? bus->data(bus, rows) : status;
}

enum pel_status pel_panel_pages_send(const struct pel_panel *panel,
                                     const struct pel_surface *surface)
{
    const struct pel_rect *a = &surface->clip, *b = &surface->bounds;
    const int32_t page = (int32_t)((uint32_t)(a->y0 - b->y0) / 8);
    struct pel_bus_rows rows = {surface->pixels, a->x1 - a->x0, 1, 0};
    enum pel_status status = (a->y0 | a->y1) & 7 ? PEL_ERROR_SIZE : PEL_OK;
    rows.bytes += page * surface->stride + a->x0 - b->x0;
    for (int32_t y = a->y0; y < a->y1 && status == PEL_OK; y += 8) {
        status = panel->chip->page(panel, panel->from[1] + y, a->x0, &rows);
        rows.bytes += surface->stride;
    }
    return status;
}
