/* A display that is a block of memory: what is flushed is copied there. It is
 * the example to copy for a driver, and the display of tests. A surface of the
 * screen's own format is copied, any other one converted.
 *
 *     static uint16_t screen[240 * 320];
 *     struct pel_display_memory memory;
 *     const struct pel_rect all = {0, 0, 240, 320};
 *     struct pel_display display;
 *     pel_surface_init(&memory.screen, &pel_rgb565_le, screen, sizeof screen,
 *                      &all);
 *     pel_display_memory_init(&display, &memory);
 */
#ifndef PEL_DRIVERS_DISPLAY_MEMORY_H
#define PEL_DRIVERS_DISPLAY_MEMORY_H

#include "display.h"

PEL_BEGIN_DECLS

struct pel_display_memory {
    struct pel_surface screen; /* what is shown; set up by the caller */
};

/* A display of the size and format of memory->screen, whose top left pixel is
 * (0, 0). Both structs stay the caller's. PEL_ERROR_NULL; PEL_ERROR_SIZE when
 * the screen does not begin at (0, 0). */
enum pel_status pel_display_memory_init(struct pel_display *display,
                                        struct pel_display_memory *memory);
PEL_END_DECLS
#endif
