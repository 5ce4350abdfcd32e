/* The angle of a direction: the inverse of pel_direction(). */
#ifndef PEL_BASE_TURN_H
#define PEL_BASE_TURN_H

#include <stdint.h>

#include "inline.h"

PEL_BEGIN_DECLS

/* 2^32 / 2 pi. */
enum { PEL_TURNS_OF_RADIAN = 683565276 };

/* The angle of (x, y) in 2^-32 of a turn, 0 along +x and growing towards +y
 * (clockwise on screen), off by less than 2^-30 turns; exact on the axes and
 * diagonals. |x|, |y| < 2^25; (0, 0) gives 0. */
uint32_t pel_turn_of(int32_t x, int32_t y);
PEL_END_DECLS
#endif
