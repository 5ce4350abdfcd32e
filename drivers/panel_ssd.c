#include "panel_chip.h"

/* Commands of Solomon Systech's OLED controllers, and of those like them. */
const uint8_t pel_panel_ssd_wake[] = {1, 0xAF, 0};
const uint8_t pel_panel_ssd_sleep[] = {1, 0xAE, 0};
