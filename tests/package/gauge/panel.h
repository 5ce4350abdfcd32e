/* What a board puts in the place of examples/panel.h, with a bus that takes
 * all. */
#include "tests/link/panel.h"

static enum pel_status panel_open(struct pel_display *display)
{
    static const struct pel_bus bus = {NULL, bus_command, bus_data, bus_pause,
                                       bus_wait};
    static struct pel_panel panel = {
        .chip = &pel_panel_gc9a01, .bus = &bus, .format = &pel_rgb565_be};
    return pel_panel_init(display, &panel);
}

static void panel_close(void)
{
}
