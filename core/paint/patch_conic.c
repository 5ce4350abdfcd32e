#include "../base/turn.h"
#include "paint_conic.h"
#include "patch.h"

#if PEL_PATCHES

/* The error, with |w| the distance of a corner from the middle, and r that of
 * the middle, 10, 8 or 6 |w| or more. Of the polynomial it is what the series
 * goes on with in |w| / r, in radians (|w| / r)^4 / 4 and more: 28,450 / r^4
 * for the largest patches. Of a row's cubic over K pixels it is K^4 / 64 s^4
 * with s, the piece's least distance, at least far[] of paint_conic_begin.c and
 * at least r - |w| - K: 400, 2,700, 36,000 or 524,288 / r^4, for K from 8 to
 * 64, and 1e-5 turns at most. Rounding adds less than 2^-24 turns. `fourth` is
 * 2^40 / r^4, r in pixels. */
static uint64_t error_of(uint64_t fourth, int64_t square, int size)
{
    static const int32_t corner[PEL_PATCH_SIZES] = {28450, 1830, 120};
    const uint64_t cubic = square >= pel_square(PEL_PX(494))   ? 524288
                           : square >= pel_square(PEL_PX(185)) ? 40000
                           : square >= pel_square(PEL_PX(71))  ? 3100
                                                               : 400;
    const uint64_t unit = fourth * (uint64_t)(PEL_TURNS_OF_RADIAN >> 8);
    const uint64_t most = UINT64_MAX / 100000, row = unit * cubic;
    return unit * (uint64_t)corner[size] + (row < most ? row : most) +
           (UINT64_C(1) << 40);
}

/* With z = x + iy from the centre and w = u + iv pixels from there, the angle
 * is Im log(z + w) = Im(log z + q w - (q w)^2 / 2 + (q w)^3 / 3 - ...), q = 1/z
 * = (x - iy) / r^2: q in 2^-30 per pixel, its square and its cube in 2^-40. */
void pel_conic_taylor(const struct pel_curve *curve, int32_t x, int32_t y,
                      int size, struct pel_taylor *t)
{
    const uint32_t start = PEL_CURVE_PAINT(struct pel_conic, curve)->start;
    const int64_t square = pel_square(x) + pel_square(y);
    const int64_t unit = INT64_C(1) << 38, turns = PEL_TURNS_OF_RADIAN;
    const int64_t re = x * unit / square, im = -y * unit / square;
    const int64_t re2 = (re * re - im * im) >> 20, im2 = re * im >> 19;
    const int64_t re3 = (re2 * re - im2 * im) >> 30;
    const int64_t im3 = (re2 * im + im2 * re) >> 30;
    const uint64_t fourth = (uint64_t)(re * re + im * im) >> 20;
    t->at = (uint64_t)(pel_turn_of(x, y) - start) << 32;
    t->x = (uint64_t)(im * turns * 4);
    t->y = (uint64_t)(re * turns * 4);
    t->xx = (uint64_t)(-im2 * turns >> 9);
    t->xy = (uint64_t)(-re2 * turns >> 8);
    t->yy = (uint64_t)(im2 * turns >> 9);
    t->xxx = (uint64_t)(im3 * (turns / 3) >> 8);
    t->xxy = (uint64_t)(re3 * turns >> 8);
    t->xyy = (uint64_t)(-im3 * turns >> 8);
    t->yyy = (uint64_t)(-re3 * (turns / 3) >> 8);
    t->error = error_of((fourth * fourth >> 40) + 1, square, size);
    t->reach = 0;
}

#endif
