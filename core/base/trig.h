/* Angles are turns: 65,536 make a full one, 0 points along +x and they grow
 * clockwise on screen (16,384 points down, along +y). */
#ifndef PEL_BASE_TRIG_H
#define PEL_BASE_TRIG_H

#include "point.h"

/* Length of a direction. */
#define PEL_DIRECTION_ONE INT32_C(32768)

/* The direction of an angle: x = 32,768 cos, y = 32,768 sin, each the nearest
 * integer for every one of the 65,536 angles, on every CPU. So the whole
 * circle is symmetric in x, y and both diagonals, directions of angles that
 * differ by a half turn are exactly opposite, and different angles have
 * different directions, in the order of the angles. */
struct pel_point pel_direction(uint16_t turn);

#endif
