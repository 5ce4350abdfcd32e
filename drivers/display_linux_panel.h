/* A panel at the SPI or I2C pins of a Linux board, as a display with memory of
 * its own: a frame, from which flush sends what is in the clip. On e-paper flip
 * begins a refresh (epaper.h). */
#ifndef PEL_DRIVERS_DISPLAY_LINUX_PANEL_H
#define PEL_DRIVERS_DISPLAY_LINUX_PANEL_H

#include "epaper.h"
#include "panel.h"
#include "../port/linux/bus.h"

PEL_BEGIN_DECLS

/* What a name asks for; the texts point into `text`. */
struct pel_panel_request {
    char text[256];
    const char *chip;                                   /* "st7789" */
    int width, height, left, top, rotation, brightness; /* -1: not said */
    bool inverted, swapped, partial;
    const char *busy; /* e-paper's line BUSY */
    struct pel_bus_request bus;
};

/* Reads "CHIP,OPTION=VALUE,...", with the options that docs/linux.md tells. 0
 * or EINVAL, with the message. */
int pel_panel_parse(struct pel_panel_request *request, const char *name,
                    struct pel_message *message);

struct pel_display_panel {
    struct pel_panel panel; /* first, as the display's context is this struct */
    struct pel_epaper paper; /* without a chip there is none */
    struct pel_display paper_display;
    struct pel_gpio busy;
    bool partial; /* refreshes after the first */
    struct pel_surface frame;
    struct pel_bus_linux bus;
    bool told; /* commands, which may have lit the chip */
};

/* Takes the bus and its lines; the chip is not told anything yet. 0 or an
 * errno, with the message, which outlives the display. */
int pel_display_panel_open(struct pel_display_panel *panel,
                           const struct pel_panel_request *request,
                           struct pel_message *message);

/* Sets the chip up, lit, and fills `display`. The same. */
int pel_display_panel_start(struct pel_display *display,
                            struct pel_display_panel *panel,
                            const struct pel_panel_request *request);

/* A panel that was set up, or nearly, is dark and asleep afterwards. Nothing
 * when it is not open. */
void pel_display_panel_close(struct pel_display_panel *panel);
PEL_END_DECLS
#endif
