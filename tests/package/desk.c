#include "port/sdl/display_sdl.h"

/* A window of SDL's driver that shows nothing takes a frame. */
int main(void)
{
    static struct pel_display_sdl window;
    static uint16_t memory[32 * 24];
    static const struct pel_rect all = {0, 0, 32, 24};
    const struct pel_display_sdl_options panel = {
        .title = "desk", .width = 32, .height = 24, .format = &pel_rgb565_le};
    struct pel_display display;
    struct pel_surface screen;
    int status = pel_display_sdl_open(&display, &window, &panel);
    if (status == PEL_OK)
        status = pel_surface_init(&screen, display.format, memory,
                                  sizeof memory, &all);
    if (status == PEL_OK)
        status = pel_display_begin(&display, &all, &screen);
    if (status == PEL_OK)
        status = pel_display_flush(&display, &screen);
    if (status == PEL_OK)
        status = pel_display_flip(&display);
    pel_display_sdl_close(&window);
    return status != PEL_OK;
}
