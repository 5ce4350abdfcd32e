#include "panel_chip.h"

/* Monochrome chips, turned by a quarter: the 8 pixels of a byte of pel_mono1,
 * from left to right, are 8 pixels of a column of the chip's memory, from the
 * bottom up. So the chip's pages lie from right to left on the screen, and each
 * is a column of bytes; what lies before the glass in `from` lies behind it
 * here. */

enum pel_status pel_panel_turned_send(const struct pel_panel *panel,
                                      const struct pel_surface *surface)
{
    const struct pel_rect *a = &surface->clip;
    struct pel_bus_rows rows = {pel_surface_line(surface, a->y0) +
                                    (a->x0 - surface->bounds.x0) / 8,
                                1, a->y1 - a->y0, surface->stride};
    const int32_t last = panel->chip->height - 8 - panel->from[1];
    enum pel_status status = (a->x0 | a->x1) & 7 ? PEL_ERROR_SIZE : PEL_OK;
    for (int32_t x = a->x0; x < a->x1 && status == PEL_OK; x += 8) {
        status = panel->chip->page(panel, last - x, a->y0, &rows);
        rows.bytes++;
    }
    return status;
}
