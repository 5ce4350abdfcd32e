/* A board with an OLED panel on a bus. */
#ifndef TESTS_DEVICE_LCD_OLED_H
#define TESTS_DEVICE_LCD_OLED_H

#include "drivers/panel.h"

/* Its bus works after oled_start. */
extern struct pel_panel oled_panel;
void oled_start(void);

#endif
