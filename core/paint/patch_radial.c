#include "../base/root.h"
#include "paint_radial.h"
#include "patch.h"

#if PEL_PATCHES

/* A pixel's distance from the centre and what follows from it: its way there
 * as a fraction of the distance, in 2^-30, and positions: per pixel of
 * distance, then divided by the distance in pixels once, twice, three times. */
struct ray {
    uint32_t root; /* 64 r */
    int64_t x, y;
    uint64_t per_pixel, once, twice, thrice;
};

/* The inverse is 2^(62 - shift) / 64 r, and the distance in pixels r / 256: so
 * a division by it is a multiplication by inverse 2^(shift - 48). */
static struct ray ray_of(uint32_t scale, int32_t x, int32_t y)
{
    const uint64_t square = (uint64_t)(pel_square(x) + pel_square(y));
    const struct pel_root r = pel_root_of(square * 4096);
    const int64_t half = (int64_t)(r.inverse >> 1), up = INT64_C(64) << r.shift;
    const uint64_t high = r.inverse >> 16;
    struct ray ray;
    ray.root = r.root;
    ray.x = x * up * half >> 31;
    ray.y = y * up * half >> 31;
    ray.per_pixel = (uint64_t)scale << 14;
    ray.once = (uint64_t)scale * r.inverse >> (34 - r.shift);
    ray.twice = ray.once * high >> (32 - r.shift);
    ray.thrice = ray.twice * high >> (32 - r.shift);
    return ray;
}

/* The error in pixels, with |w| the distance of a corner from the middle, and
 * r that of the middle, 10, 8 or 6 |w| or more. Of the polynomial it is |r''''|
 * |w|^4 / 24 with |r''''| <= 3 / (r - |w|)^3 along any line: 17,562 / r^3 for
 * the largest patches. Of a row's cubic over K pixels it is K^4 / 128 s^3 with
 * s, the piece's least distance, at least far[] of paint_radial.c and at least
 * r - |w| - K: 110, 1,400, 18,400 or 230,000 / r^3, for K from 8 to 64 (which
 * begin at far[] - |w|), and 1/512 at most. Roots are rounded down in both, so
 * they add 1/16,384; what else is rounded, of the inverse's 22 bits most, adds
 * less than half of that; 1/4,096 is granted. */
static uint64_t error_of(const struct ray *ray, int size)
{
    static const int32_t corner[PEL_PATCH_SIZES] = {17562, 1195, 87};
    const uint32_t r = ray->root >> 14;
    const uint64_t cubic = r >= 388   ? 230000
                           : r >= 143 ? 18400
                           : r >= 55  ? 1400
                                      : 110;
    const uint64_t most = ray->per_pixel >> 9, row = ray->thrice * cubic;
    return ray->thrice * (uint64_t)corner[size] + (row < most ? row : most) +
           (ray->per_pixel >> 12);
}

/* The derivatives of r = sqrt(x^2 + y^2): of the first order x/r, y/r; of the
 * second y^2/r^3, -xy/r^3, x^2/r^3; of the third -3xy^2/r^5, y(2x^2 - y^2)/r^5,
 * x(2y^2 - x^2)/r^5, -3x^2y/r^5. */
void pel_radial_taylor(const struct pel_curve *curve, int32_t x, int32_t y,
                       int size, struct pel_taylor *t)
{
    const struct pel_radial *p = PEL_CURVE_PAINT(struct pel_radial, curve);
    const struct ray ray = ray_of(p->scale, x, y);
    const int64_t xx = ray.x * ray.x >> 38, xy = ray.x * ray.y >> 38;
    const int64_t yy = ray.y * ray.y >> 38, once = (int64_t)ray.once;
    const int64_t tx = (int64_t)ray.twice * (ray.x >> 15) >> 15;
    const int64_t ty = (int64_t)ray.twice * (ray.y >> 15) >> 15;
    t->at = (uint64_t)ray.root * p->scale + p->phase;
    t->x = (uint64_t)(ray.x * p->scale >> 16);
    t->y = (uint64_t)(ray.y * p->scale >> 16);
    t->xx = (uint64_t)(once * yy >> 23);
    t->xy = (uint64_t)(-once * xy >> 22);
    t->yy = (uint64_t)(once * xx >> 23);
    t->xxx = (uint64_t)(-tx * yy >> 23);
    t->xxy = (uint64_t)(ty * (2 * xx - yy) >> 23);
    t->xyy = (uint64_t)(tx * (2 * yy - xx) >> 23);
    t->yyy = (uint64_t)(-ty * xx >> 23);
    t->error = error_of(&ray, size);
    t->reach = (ray.per_pixel * 18 >> size) + t->error;
}

#endif
