/* The lines of docs/use.md that open a window, which then shows a frame. */
#include <stdio.h>

#include "port/sdl/display_sdl.h"

int main(void)
{
    static const struct pel_rect all = {0, 0, 240, 240};
    static uint16_t memory[240 * 240];
    struct pel_display display;
    struct pel_surface screen;
    enum pel_status status;
#include "window.inc"
    if (status == PEL_OK)
        status = pel_surface_init(&screen, display.format, memory,
                                  sizeof memory, &all);
    if (status == PEL_OK)
        status = pel_display_flush(&display, &screen);
    if (status == PEL_OK)
        status = pel_display_flip(&display);
    pel_display_sdl_close(&window);
    return status != PEL_OK;
}
