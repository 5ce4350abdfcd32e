/* Touch screens: a controller's fingers as events, in pixels of the display.
 *
 *     static struct pel_touch touch = {.bus = &bus,
 *                                      .read = pel_touch_xpt2046_read};
 *     pel_touch_calibrate(&touch.map, pairs, 320, 240);
 *     every 10 ms or so, or when the controller's interrupt line says so and
 *     until no finger is left:
 *         pel_touch_poll(&touch, time, &queue);
 */
#ifndef PEL_DRIVERS_TOUCH_H
#define PEL_DRIVERS_TOUCH_H

#include <stdbool.h>

#include "bus.h"
#include "input.h"

PEL_BEGIN_DECLS

enum { PEL_TOUCH_FINGERS = 2, PEL_TOUCH_MOST = 4095 };

struct pel_touch_point {
    int16_t x, y; /* 0..PEL_TOUCH_MOST */
};

/* What the controller feels now, in its own units. Bit i of `down`: finger i
 * is on the screen, at points[i]. PEL_ERROR_DEVICE when it does not answer, or
 * nothing that it could mean. */
typedef enum pel_status pel_touch_read(
    const struct pel_bus *bus, struct pel_touch_point points[PEL_TOUCH_FINGERS],
    unsigned *down);

/* XPT2046, ADS7843 and their like, on SPI (mode 0, at most 2 MHz): one finger,
 * who must press a little. */
pel_touch_read pel_touch_xpt2046_read;

/* FT6206, FT6236 and their like, on I2C (address 0x38): two fingers. */
pel_touch_read pel_touch_ft6206_read;

/* From a controller's units to pixels: x and y grow by these per unit, in
 * 1/65536, from `from` on, which is the pixel `to`. */
struct pel_touch_map {
    int32_t x_by_x, x_by_y, y_by_x, y_by_y; /* below 2 px */
    struct pel_touch_point from, to;
    int16_t width, height; /* px of the display */
};

/* A point that was shown and the one that was read when a finger was there. */
struct pel_touch_pair {
    struct pel_touch_point shown, read;
};

/* The map that takes three points to where they were shown: turned, mirrored or
 * skewed as it may be. They lie far apart, not in a line. PEL_ERROR_RANGE when
 * they do not, when one is not within 0..PEL_TOUCH_MOST, or when a unit would
 * be 2 pixels or more; PEL_ERROR_SIZE when width or height is not within
 * 1..PEL_TOUCH_MOST + 1. The map stays as it was, then. */
enum pel_status pel_touch_calibrate(struct pel_touch_map *map,
                                    const struct pel_touch_pair pairs[3],
                                    int width, int height);

/* The pixel of the display, whose border is the nearest for points outside. */
struct pel_touch_point pel_touch_map_point(const struct pel_touch_map *map,
                                           struct pel_touch_point point);

struct pel_touch {
    const struct pel_bus *bus;
    pel_touch_read *read;
    struct pel_touch_map map;
    struct pel_touch_point last[PEL_TOUCH_FINGERS]; /* px */
    unsigned down;   /* bit i: finger i, as told last */
    uint16_t losses; /* of the queue, as seen last */
};

/* Reads the controller and pushes what has changed, after a loss all fingers
 * that are held. When it fails all fingers are lifted. */
enum pel_status pel_touch_poll(struct pel_touch *touch, uint32_t time,
                               struct pel_input_queue *queue);

PEL_END_DECLS
#endif
