/* What a board puts in the place of examples/panel.h, with a bus that takes
 * all. */
#include "tests/link/panel.h"

static enum pel_status panel_open(struct pel_display *display, int32_t width,
                                  int32_t height,
                                  const struct pel_format *format)
{
    static const struct pel_bus bus = {NULL, bus_command, bus_data, bus_pause,
                                       bus_wait};
    static struct pel_panel panel = {
        .chip = &pel_panel_gc9a01, .bus = &bus, .format = &pel_rgb565_be};
    const enum pel_status status = pel_panel_init(display, &panel);
    if (status == PEL_OK &&
        (display->width != width || display->height != height ||
         display->format != format))
        return PEL_ERROR_SIZE;
    return status;
}

static void panel_close(void)
{
}
