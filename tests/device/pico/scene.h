/* What the board shows, and the host again: a gauge with a needle, which the
 * encoder turns, and a spot under the finger; on the small panel how far it is
 * turned, how often the button was pressed, and a disc while it is held. */
#ifndef TESTS_DEVICE_PICO_SCENE_H
#define TESTS_DEVICE_PICO_SCENE_H

#include "drivers/dirty.h"

enum { LCD_SIDE = 240, OLED_WIDTH = 128, OLED_HEIGHT = 64 };

struct scene {
    int32_t degrees; /* 0 to 270 */
    int32_t presses;
    int32_t held; /* 0 or 1 */
    int32_t x, y; /* px, of the finger; x < 0: none */
};

/* For pel_dirty_work: `context` is the scene. */
void scene_draw_lcd(void *context, const struct pel_surface *screen);
void scene_draw_oled(void *context, const struct pel_surface *screen);

/* Adds where two scenes may differ. */
void scene_changes(const struct scene *before, const struct scene *now,
                   struct pel_dirty_areas *lcd, struct pel_dirty_areas *oled);

#endif
