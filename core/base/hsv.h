/* Hue, saturation, value to RGB, exact: the rational form in integers.
 *
 * A turn of hue goes red, yellow, green, cyan, blue, magenta. With F the part
 * of its sixth that a hue has gone, 0 <= F < 1, the channels are v and
 *     p = v (1 - s),  q = v (1 - s F),  t = v (1 - s (1 - F)),
 * s and v in [0, 1] given as 0..255, results in 0..255 rounded to the nearest
 * (a tie upwards). */
#ifndef PEL_BASE_HSV_H
#define PEL_BASE_HSV_H

#include "color.h"

PEL_BEGIN_DECLS

/* hue in 1/65,536 turns, any: -1 is 65,535. s and v 0..255. Opaque. */
pel_color pel_hsv(int32_t hue, uint32_t s, uint32_t v);

/* hue in degrees, any: 360 is 0, -1 is 359. */
pel_color pel_hsv_degrees(int32_t hue, uint32_t s, uint32_t v);
PEL_END_DECLS
#endif
