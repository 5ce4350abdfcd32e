/* Transforms of what has units of its own: letters, icons. */
#ifndef PEL_PATH_TRANSFORM_H
#define PEL_PATH_TRANSFORM_H

#include "../base/trig.h"
#include "path.h"

/* Where a point lies; false: out of range. */
bool pel_transform_point(const struct pel_transform *transform, int32_t x,
                         int32_t y, struct pel_point *to);

/* So many units, 1 or more, become `size` (1/256 px, 0..32,767 px): 65,536 size
 * / units, cut off; below 2^31 for 256 units and more. */
static inline int32_t pel_transform_scale(int32_t size, uint32_t units)
{
    const uint32_t s = (uint32_t)size;
    return (int32_t)((s / units << 16) + (s % units << 16) / units);
}

/* Turned clockwise about `at`, of units that grow upwards or not: (cos, -sin;
 * sin, cos) times scale / 2^31. */
static inline struct pel_transform pel_transform_turned(int32_t scale,
                                                        int32_t turn, bool up,
                                                        struct pel_point at)
{
    const struct pel_point d = pel_direction((uint16_t)turn);
    const int32_t c = (int32_t)((pel_long_product(scale, d.x) + 16384) >> 15);
    const int32_t n = (int32_t)((pel_long_product(scale, d.y) + 16384) >> 15);
    return (struct pel_transform){c, up ? n : -n, n, up ? -c : c, at};
}

/* The pixels of a box of units, and one more on each side; all where they are
 * out of range. */
static inline struct pel_rect pel_transform_box(const struct pel_transform *t,
                                                struct pel_rect units)
{
    struct pel_point v[4];
    bool legal = true;
    for (int i = 0; i < 4; i++)
        legal &= pel_transform_point(t, i & 1 ? units.x1 : units.x0,
                                     i & 2 ? units.y1 : units.y0, &v[i]);
    const struct pel_rect box = pel_points_box(v, 4);
    const struct pel_rect all = {-32768, -32768, 32768, 32768};
    return legal ? (struct pel_rect){(box.x0 >> 8) - 1, (box.y0 >> 8) - 1,
                                     (box.x1 >> 8) + 2, (box.y1 >> 8) + 2}
                 : all;
}

#endif
