/* A board with an OLED panel on a bus. */
#ifndef TESTS_DEVICE_LCD_OLED_H
#define TESTS_DEVICE_LCD_OLED_H

#include "drivers/panel.h"

/* Its bus works after oled_start. */
extern struct pel_panel oled_panel;
void oled_start(void);

/* Of its bus; the emulator has no reset line, and needs no time. */
enum pel_status oled_pause(const struct pel_bus *bus, bool reset, uint32_t ms);

#endif
