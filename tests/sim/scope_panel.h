/* The panel of examples/scope.c as a chip that scrolls by itself, behind a bus
 * with a DMA. Its model, which the chip's data sheet alone has made, has to
 * show what the panel in memory would; that is written in the end. */
#ifndef TESTS_SIM_SCOPE_PANEL_H
#define TESTS_SIM_SCOPE_PANEL_H

#include <stdlib.h>

#include "drivers/panel_scroll.h"
#include "examples/ppm.h"
#include "tests/support/panel_glass.h"

enum { PANEL_WIDTH = 480, PANEL_HEIGHT = 320 };

static struct bus_log panel_bus = {.dma = true};
static struct panel_glass panel_model = {.family = PANEL_DCS,
                                         .columns = PANEL_HEIGHT,
                                         .rows = PANEL_WIDTH,
                                         .columns_backward = true};
static struct pel_panel panel_chip = {
    .chip = &pel_panel_st7796, .bus = &panel_bus.bus, .rotation = 1};
static struct pel_panel_scroll panel_rolls;
static struct pel_display panel_still, panel_rolling;
static uint16_t panel_memory[PANEL_WIDTH * PANEL_HEIGHT];
static struct pel_surface panel_shown;

static void panel_fail(const char *what)
{
    fprintf(stderr, "%s\n", what);
    exit(1);
}

static void panel_take(void)
{
    int at[2];
    panel_glass_take(&panel_model, &panel_bus, 0);
    panel_bus.count = 0;
    if (!panel_glass_shows(&panel_model, &panel_shown, panel_chip.rotation, at))
        panel_fail("the chip shows another picture");
}

static enum pel_status panel_flush(const struct pel_display *display,
                                   const struct pel_surface *s)
{
    const struct pel_copy_part part = {s, s->clip, s->clip.x0, s->clip.y0};
    (void)display;
    pel_copy(&panel_shown, &part);
    return pel_display_flush(&panel_rolling, s);
}

static enum pel_status panel_wait(const struct pel_display *display)
{
    (void)display;
    return pel_display_wait(&panel_rolling);
}

static enum pel_status panel_flip(const struct pel_display *display)
{
    (void)display;
    panel_take();
    return PEL_OK;
}

static enum pel_status panel_open(struct pel_display *display, int32_t width,
                                  int32_t height,
                                  const struct pel_format *format)
{
    const struct pel_rect all = {0, 0, PANEL_WIDTH, PANEL_HEIGHT};
    bus_log_init(&panel_bus);
    panel_glass_reset(&panel_model);
    panel_chip.format = format;
    if (pel_panel_init(&panel_still, &panel_chip) != PEL_OK ||
        pel_panel_scroll_init(&panel_rolling, &panel_rolls, &panel_still, 0,
                              320) != PEL_OK ||
        panel_rolling.width != width || panel_rolling.height != height)
        panel_fail("no panel");
    *display = panel_rolling;
    display->flush = panel_flush;
    display->wait = panel_wait;
    display->flip = panel_flip;
    return pel_surface_init(&panel_shown, format, panel_memory,
                            sizeof panel_memory, &all);
}

static enum pel_status panel_scroll(const struct pel_display *display,
                                    const struct pel_rect *area, int32_t n)
{
    (void)display;
    pel_scroll(&panel_shown, area, -n, 0);
    return pel_panel_scroll_by(&panel_rolls, n);
}

static void panel_close(void)
{
    printf("P6\n%d %d 255\n", PANEL_WIDTH, PANEL_HEIGHT);
    ppm_write(&panel_shown);
}

#endif
