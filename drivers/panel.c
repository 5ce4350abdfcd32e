#include "panel_chip.h"

#include <string.h>

enum pel_status pel_panel_brightness(const struct pel_panel *panel,
                                     uint8_t level)
{
    const uint8_t list[] = {2, panel->chip->brightness,
                            (uint8_t)(level >> panel->chip->shift), 0};
    return panel->chip->command(panel, list);
}

enum pel_status pel_panel_sleep(const struct pel_panel *panel, bool asleep)
{
    return panel->chip->command(panel, asleep ? panel->chip->sleep
                                              : panel->chip->wake);
}

static enum pel_status panel_wait(const struct pel_display *display)
{
    const struct pel_panel *panel = display->context;
    const struct pel_bus *bus = panel->bus;
    return bus->wait ? bus->wait(bus) : PEL_OK;
}

static enum pel_status panel_flush(const struct pel_display *display,
                                   const struct pel_surface *surface)
{
    const struct pel_panel *panel = display->context;
    const struct pel_rect *area = &surface->clip;
    if (pel_rect_empty(area))
        return PEL_OK;
    if (surface->format->id != display->format->id)
        return PEL_ERROR_FORMAT;
    if ((area->x0 | area->y0) < 0 || area->x1 > display->width ||
        area->y1 > display->height)
        return PEL_ERROR_SIZE;
    return panel->chip->send(panel, surface);
}

/* A quarter turn and a half one run backwards through the columns of memory, a
 * half one and three quarters through its rows; so what is beside the glass
 * lies before its first pixel then. */
static enum pel_status place(struct pel_panel *panel)
{
    const struct pel_panel_chip *chip = panel->chip;
    const struct pel_bus *bus = panel->bus;
    if (!chip || !bus || !bus->data || !bus->pause || !panel->format)
        return PEL_ERROR_NULL;
    if (panel->format->id != chip->formats[panel->rotation & 1])
        return PEL_ERROR_FORMAT;
    if (!panel->width)
        panel->width = chip->width;
    if (!panel->height)
        panel->height = chip->height;
    const int32_t left = chip->left + panel->left;
    const int32_t right = chip->columns - left - panel->width;
    panel->from[0] = (panel->rotation + 1) & 2 ? right : left;
    const int32_t below = chip->height - panel->top - panel->height;
    panel->from[1] = panel->rotation & 2 ? below : panel->top;
    return (right | below) < 0 ? PEL_ERROR_SIZE : PEL_OK;
}

static enum pel_status start(const struct pel_panel *panel)
{
    const struct pel_panel_chip *chip = panel->chip;
    const uint8_t *turn = chip->turn[panel->rotation & 3];
    const uint8_t list[] = {2,
                            turn[0],
                            (uint8_t)(turn[1] ^ (panel->swapped * chip->swap)),
                            1,
                            chip->inversion ^ panel->inverted,
                            0};
    enum pel_status status = panel->bus->pause(panel->bus, true, 120);
    if (status == PEL_OK)
        status = chip->command(panel, chip->setup);
    return status == PEL_OK ? chip->command(panel, list) : status;
}

enum pel_status pel_panel_init(struct pel_display *display,
                               struct pel_panel *panel)
{
    if (!display || !panel)
        return PEL_ERROR_NULL;
    enum pel_status status = place(panel);
    if (status != PEL_OK)
        return status;
    const bool turned = panel->rotation & 1;
    memset(display, 0, sizeof *display);
    display->context = panel;
    display->width = turned ? panel->height : panel->width;
    display->height = turned ? panel->width : panel->height;
    display->format = panel->format;
    display->flush = panel_flush;
    display->wait = panel_wait;
    return start(panel);
}
