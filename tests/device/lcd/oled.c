/* On a board with an OLED panel: sends a part of the picture of
 * device/linux/reference.pel, window by window, and has the glass dumped. */
#include "oled.h"

#include "guest.h"

/* Of windows, and the pixel of the picture that is the first of the glass. */
enum { WIDTH = 32, HEIGHT = 8, LEFT = 224, TOP = 48 };

enum pel_status oled_pause(const struct pel_bus *bus, bool reset, uint32_t ms)
{
    (void)bus, (void)reset, (void)ms;
    return PEL_OK;
}

static bool show_window(const struct pel_display *display, int32_t x, int32_t y)
{
    static uint8_t pixels[WIDTH * HEIGHT / 2];
    const struct pel_rect part = {x + LEFT, y + TOP, x + LEFT + WIDTH,
                                  y + TOP + HEIGHT};
    struct pel_surface s;
    if (pel_surface_init(&s, display->format, pixels, sizeof pixels, &part))
        return false;
    guest_draw(&s);
    s.bounds = s.clip = (struct pel_rect){x, y, x + WIDTH, y + HEIGHT};
    return !pel_display_flush(display, &s);
}

int main(void)
{
    struct pel_display display;
    oled_start();
    bool done = !pel_panel_init(&display, &oled_panel);
    for (int32_t y = 0; done && y < display.height; y += HEIGHT)
        for (int32_t x = 0; x < display.width; x += WIDTH)
            done = show_window(&display, x, y) && done;
    guest_ask("@dump glass\n");
    guest_done(done);
}
