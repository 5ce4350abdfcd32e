/* The HSV wheel as a conic paint. */
#ifndef PEL_PAINT_PAINT_HUE_H
#define PEL_PAINT_PAINT_HUE_H

#include "paint_conic.h"

PEL_BEGIN_DECLS

/* pel_hsv(hue, s, v) with the hue that a pixel's angle is, less start, in
 * 1/65,536 turns rounded down: no ramp, and no memory for one. */
struct pel_hue_wheel {
    struct pel_conic conic;
    uint8_t s, v;
};

/* PEL_ERROR_NULL, PEL_ERROR_RANGE (the centre out of range). */
enum pel_status pel_hue_wheel_init(struct pel_hue_wheel *paint,
                                   struct pel_point center, uint16_t start,
                                   uint8_t s, uint8_t v);
PEL_END_DECLS
#endif
