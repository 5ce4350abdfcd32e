/* How far the nearest texel is from the bilinear mix.
 *
 * Bilinear texels mix four that meet in a point, a b over c d. Where a is the
 * nearest, the others have weights u and v of 1/2 at most: the difference is
 *
 *     u (1 - v) (b - a) + (1 - u) v (c - a) + u v (d - a),
 *
 * which is largest in size at a corner of 0 <= u, v <= 1/2, since it is linear
 * in u and in v:
 *
 *     (b - a) / 2, (c - a) / 2, or (b + c + d - 3 a) / 4.
 *
 * Weights of 1/256 are rounded to no more than 1/2, and the mix is rounded
 * once, so the bound is the largest of these, rounded. It is reached: the four
 * meet somewhere in the picture. Slow gradients have one of a step or two, and
 * pictures with hard edges or noise, such as photos, one of 50 and more. */
#ifndef PEL_PAINT_TEXTURE_CONTRAST_H
#define PEL_PAINT_TEXTURE_CONTRAST_H

#include "paint_texture.h"

PEL_BEGIN_DECLS

/* That bound of a channel, 0 to 191, plus 1; of a texture that is repeated, as
 * that bounds the other wrap modes. 0: there is none, as alphas differ or the
 * texels cannot be read. */
uint8_t pel_texels_contrast(const struct pel_texels *texels);
PEL_END_DECLS
#endif
