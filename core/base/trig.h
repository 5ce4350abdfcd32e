/* Angles are turns: 65,536 make a full one, 0 points along +x and they grow
 * clockwise on screen (16,384 points down, along +y). */
#ifndef PEL_BASE_TRIG_H
#define PEL_BASE_TRIG_H

#include "point.h"

PEL_BEGIN_DECLS

/* Length of a direction. */
#define PEL_DIRECTION_ONE INT32_C(32768)

/* The direction of an angle: x = 32,768 cos, y = 32,768 sin, each the nearest
 * integer, on every CPU. So the circle is symmetric in x, y and both diagonals,
 * and different angles have different directions, in the order of the angles.
 */
struct pel_point pel_direction(uint16_t turn);

/* An angle of n degrees, cut off to whole turns / 65,536; a constant n may have
 * a fraction: PEL_DEGREES(90) is 16,384. */
#define PEL_DEGREES(n) PEL_CAST(int32_t, (n)*INT64_C(65536) / 360)

/* `p` turned clockwise about `center`, each coordinate rounded to the nearest
 * sub-pixel (a tie towards +); off by 1/32,768 of the distance besides. Both
 * points are in range; the result may lie outside. */
struct pel_point pel_turned(struct pel_point p, struct pel_point center,
                            int32_t turn);

/* The point `radius` (1/256 px, up to 32,767 px) from `center` in the direction
 * of `turn`: the end of a hand, a mark of a scale. Rounded like pel_turned. */
static inline struct pel_point pel_polar(struct pel_point center,
                                         int32_t radius, int32_t turn)
{
    const struct pel_point right = {center.x + radius, center.y};
    return pel_turned(right, center, turn);
}

/* 2^32 / 2 pi. */
enum { PEL_TURNS_OF_RADIAN = 683565276 };

/* The inverse: the angle of (x, y) in 2^-32 of a turn, 0 along +x and growing
 * towards +y (clockwise on screen), off by less than 2^-30 turns; exact on the
 * axes and diagonals. |x|, |y| < 2^25; (0, 0) gives 0. */
uint32_t pel_turn_of(int32_t x, int32_t y);
PEL_END_DECLS
#endif
