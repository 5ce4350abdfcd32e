#include "panel_chip.h"

/* Parameters are sent like commands. */
enum pel_status pel_panel_ssd_command(const struct pel_panel *panel,
                                      const uint8_t *list)
{
    const struct pel_bus *bus = panel->bus;
    enum pel_status status = PEL_OK;
    for (; *list && status == PEL_OK; list += *list + 1)
        status = bus->command(bus, list + 1, *list, NULL, 0);
    return status;
}

/* Commands of Solomon Systech's OLED controllers, and of those like them. */
const uint8_t pel_panel_ssd_wake[] = {1, 0xAF, 0};
const uint8_t pel_panel_ssd_sleep[] = {1, 0xAE, 0};
