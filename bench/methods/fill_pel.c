#include "fill.h"

static void draw(const struct pel_surface *s, const struct pel_point v[3],
                 uint32_t pixel)
{
    const struct pel_flat paint = PEL_FLAT(pixel);
    pel_triangle(s, v, &paint.paint);
}

const struct fill_method fill_pel = {"pel", 8, draw};

bool fill_is_pel(const struct fill_method *m)
{
    return m == &fill_pel;
}

const struct fill_method *const fill_methods[] = {
    &fill_pel,
    &fill_fixed_rounded,
    &fill_fixed_truncated,
    &fill_float_scanline,
    &fill_float_stepped,
    &fill_barycentric,
    &fill_barycentric_ties,
    &fill_barycentric_derived,
    &fill_half_space_64,
    &fill_half_space_32,
    &fill_half_space_32_4,
    NULL,
};
