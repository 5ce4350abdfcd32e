/* A bus that takes all, and a panel behind it: what its driver costs. */
#ifndef TESTS_LINK_PANEL_H
#define TESTS_LINK_PANEL_H

#include "drivers/panel.h"

static enum pel_status bus_command(const struct pel_bus *bus,
                                   const uint8_t *bytes, size_t n,
                                   uint8_t *answer, size_t answers)
{
    (void)bus, (void)bytes, (void)n, (void)answer, (void)answers;
    return PEL_OK;
}

static enum pel_status bus_data(const struct pel_bus *bus,
                                const struct pel_bus_rows *rows)
{
    (void)bus, (void)rows;
    return PEL_OK;
}

static enum pel_status bus_pause(const struct pel_bus *bus, bool reset,
                                 uint32_t ms)
{
    (void)bus, (void)reset, (void)ms;
    return PEL_OK;
}

static enum pel_status bus_wait(const struct pel_bus *bus)
{
    (void)bus;
    return PEL_OK;
}

/* Sets up the panel and sends `surface`: 0, as main returns it. */
static inline int show(const struct pel_panel_chip *chip,
                       const struct pel_surface *surface)
{
    static const struct pel_bus bus = {NULL, bus_command, bus_data, bus_pause,
                                       bus_wait};
    struct pel_panel panel = {
        .chip = chip, .bus = &bus, .format = surface->format};
    struct pel_display display;
    return pel_panel_init(&display, &panel) ||
           pel_display_flush(&display, surface) || pel_display_wait(&display);
}

#endif
