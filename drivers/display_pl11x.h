/* LCD controllers of Arm, PL110 and PL111: they show a frame that lies in
 * memory, in words of 16 or 32 bits and in either byte order. What is drawn is
 * seen at once: nothing is copied, and flush has nothing to do. A system with
 * caches maps the frame uncached.
 *
 *     static struct pel_display_pl11x lcd = {
 *         .kind = PEL_PL111, .registers = (volatile uint32_t *)0x10020000};
 *     const struct pel_rect all = {0, 0, 640, 480};
 *     struct pel_display display;
 *     pel_surface_init(&lcd.screen, &pel_rgb565_le, frame, sizeof frame,
 *                      &all);
 *     pel_display_pl11x_init(&display, &lcd);
 */
#ifndef PEL_DRIVERS_DISPLAY_PL11X_H
#define PEL_DRIVERS_DISPLAY_PL11X_H

#include "display.h"

PEL_BEGIN_DECLS

/* A PL110 has 5-5-5 in 16 bits; on the boards of Arm a multiplexer makes 5-6-5
 * of it, which they are told in a register of theirs. On Versatile boards its
 * registers stand as in a PL111. */
enum pel_pl11x_kind { PEL_PL110, PEL_PL110_VERSATILE, PEL_PL111 };

struct pel_display_pl11x {
    enum pel_pl11x_kind kind;
    volatile uint32_t *registers;

    /* The frame that is shown; set up by the caller. From (0, 0), rows without
     * padding, at an address below 4 GB that is a multiple of 8; a multiple of
     * 16 px, 16 to 1024, wide and 1 to 1024 px high; rgb565_le, rgb565_be,
     * bgr565_le, xrgb8888, xbgr8888, rgbx8888 or bgrx8888. */
    struct pel_surface screen;

    /* What the panel's data sheet says, as LCDTiming0 to 3 have it: porches,
     * lengths of the synchronising pulses, polarities, clocks. The number of
     * pixels and lines in it is 0: init puts it in. */
    uint32_t timing[4];
};

/* Sets up the controller and switches it on. Both structs and the frame stay
 * the caller's. 16 bits a pixel on a PL110, which has 5-5-5 only, take boards
 * that make 5-6-5 of it, as Versatile boards do. PEL_ERROR_NULL,
 * PEL_ERROR_SIZE, PEL_ERROR_STRIDE, PEL_ERROR_ALIGNMENT, PEL_ERROR_FORMAT:
 * nothing was touched then. */
enum pel_status pel_display_pl11x_init(struct pel_display *display,
                                       struct pel_display_pl11x *lcd);
PEL_END_DECLS
#endif
