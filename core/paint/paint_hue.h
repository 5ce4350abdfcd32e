/* The HSV wheel as a conic paint. */
#ifndef PEL_PAINT_PAINT_HUE_H
#define PEL_PAINT_PAINT_HUE_H

#include "paint_conic.h"

PEL_BEGIN_DECLS

/* A conic of 1,536 cells, 256 in each sixth of the turn, so that one channel
 * moves by at most one step from cell to cell. Cell k has the color of the hue
 * in its middle, (k + 1/2) / 1,536 turns, rounded as pel_hsv rounds: no ramp,
 * and no memory for one. */
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
