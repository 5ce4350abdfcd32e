/* PAPER names an e-paper controller, FORMAT what it takes, IDLE the level of
 * its pin BUSY that is idle: what its driver costs. */
#include "panel.h"

#include "drivers/epaper.h"

static uint8_t frame[2 * PEL_EPAPER_FRAME(128, 128)], pixels[128 / 4 * 128];

static const struct pel_surface screen = {.pixels = pixels,
                                          .stride = 128 / 4,
                                          .bounds = {0, 0, 128, 128},
                                          .clip = {0, 0, 128, 128},
                                          .format = &FORMAT};

static bool busy(const struct pel_epaper *paper)
{
    (void)paper;
    return IDLE;
}

int main(void)
{
    static const struct pel_bus bus = {NULL, bus_command, bus_data, bus_pause,
                                       bus_wait};
    struct pel_epaper paper = {.chip = &PAPER,
                               .bus = &bus,
                               .busy = busy,
                               .format = &FORMAT,
                               .frame = frame,
                               .width = 128,
                               .height = 128};
    struct pel_display display;
    return pel_epaper_init(&display, &paper) ||
           pel_display_flush(&display, &screen) || pel_display_flip(&display) ||
           pel_epaper_sleep(&paper);
}
