/* The panel of the examples as a Linux device without a desktop: what
 * FRAMEBUFFER names, or /dev/fb0, or DRM, with the keys and fingers of all that
 * is plugged in: `make device EXAMPLE=kiosk`. Its size and format are its own.
 */
#ifndef EXAMPLES_LINUX_H
#define EXAMPLES_LINUX_H

#include <stdio.h>

#include "drivers/display_linux.h"
#include "port/linux/input.h"

static struct pel_display_linux panel_screen;
static struct pel_input_linux panel_user;

static inline enum pel_status panel_open(struct pel_display *display,
                                         int32_t width, int32_t height,
                                         const struct pel_format *format)
{
    struct pel_input_linux_options options = {.buttons = NULL};
    (void)width, (void)height, (void)format;
    if (pel_display_linux_open(&panel_screen, NULL, PEL_FB_ANY) != PEL_OK) {
        fprintf(stderr, "%s\n", panel_screen.message.text);
        return PEL_ERROR_DEVICE;
    }
    *display = panel_screen.display;
    options.width = panel_screen.area.x1;
    options.height = panel_screen.area.y1;
    fprintf(stderr, "%s\n", panel_screen.note.text);
    if (pel_input_linux_open(&panel_user, &options) != 0)
        fprintf(stderr, "%s\n", panel_user.message.text);
    return PEL_OK;
}

static inline enum pel_status panel_scroll(const struct pel_display *display,
                                           const struct pel_rect *area,
                                           int32_t n)
{
    (void)display, (void)area, (void)n;
    fprintf(stderr, "a framebuffer does not scroll by itself\n");
    return PEL_ERROR_FORMAT;
}

/* Lets another terminal be shown, and waits a frame for what the user does. */
static inline bool panel_input(struct pel_input *event)
{
    pel_display_linux_wait(&panel_screen, 0);
    return pel_input_linux_wait(&panel_user, 33, event);
}

static inline void panel_close(void)
{
    pel_input_linux_close(&panel_user);
    pel_display_linux_close(&panel_screen);
}

#endif
