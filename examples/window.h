/* The panel of the examples as a window: `make window EXAMPLE=watch`, which
 * says PANEL_TITLE and PANEL_PERIOD, ms from frame to frame. */
#ifndef EXAMPLES_WINDOW_H
#define EXAMPLES_WINDOW_H

#include <stdio.h>
#include <stdlib.h>

#include "port/sdl/display_sdl.h"

static struct pel_display_sdl panel_window;

static inline enum pel_status panel_open(struct pel_display *display,
                                         int32_t width, int32_t height,
                                         const struct pel_format *format)
{
    const struct pel_display_sdl_options options = {.title = PANEL_TITLE,
                                                    .width = width,
                                                    .height = height,
                                                    .format = format,
                                                    .period = PANEL_PERIOD,
                                                    .touch = true};
    const enum pel_status status =
        pel_display_sdl_open(display, &panel_window, &options);
    if (panel_window.message)
        fprintf(stderr, "%s: %s\n", PANEL_TITLE, panel_window.message);
    return status;
}

/* As a panel that scrolls by itself. */
static inline enum pel_status panel_scroll(const struct pel_display *display,
                                           const struct pel_rect *area,
                                           int32_t n)
{
    (void)display;
    pel_scroll(&panel_window.glass, area, -n, 0);
    return PEL_OK;
}

/* What the user has done; false: nothing more. */
static inline bool panel_input(struct pel_input *event)
{
    return pel_display_sdl_next(&panel_window, event);
}

/* The last frame stays until the user closes the window. That he does it before
 * is no failure, though the display has failed: the program ends well. */
static inline void panel_close(void)
{
    const bool panel_ended = panel_window.closed && !panel_window.message;
    struct pel_input event;
    if (!panel_window.closed)
        fprintf(stderr,
                "%s has ended; its last frame stays until the window is "
                "closed\n",
                PANEL_TITLE);
    while (pel_display_sdl_wait(&panel_window, -1, &event)) {
    }
    pel_display_sdl_close(&panel_window);
    if (panel_ended)
        exit(EXIT_SUCCESS);
}

#endif
