#include "plane.h"

#include "../raster/fraction.h"
#include "../raster/triangle_sort.h"

bool pel_plane_start(struct pel_plane_setup *setup, const struct pel_point v[3])
{
    const struct pel_point *p[3] = {&v[0], &v[1], &v[2]};
    struct pel_plane_setup *s = setup;
    pel_sort3(p);
    s->a = *p[0];
    s->ab = (struct pel_point){p[1]->x - s->a.x, p[1]->y - s->a.y};
    s->ac = (struct pel_point){p[2]->x - s->a.x, p[2]->y - s->a.y};
    s->first = (uint8_t)(p[0] - v);
    s->second = (uint8_t)(p[1] - v);
    s->third = (uint8_t)(p[2] - v);
    s->area = (int64_t)s->ab.x * s->ac.y - (int64_t)s->ac.x * s->ab.y;
    if (s->area < 0) {
        const struct pel_point ab = s->ab;
        const uint8_t second = s->second;
        s->ab = s->ac;
        s->ac = ab;
        s->second = s->third;
        s->third = second;
        s->area = -s->area;
    }
    return s->area != 0;
}

/* A gradient is nx / area with nx = (vb - va) ac.y - (vc - va) ab.y, below
 * 2^58; in y alike. The anchor is the pixel of a. Where its centre lies, up to
 * 128 sub-pixels from a, takes the gradient to 2^-24 of a sub-pixel; a step of
 * a pixel is 256 of these, and eight more bits of it keep the longest way right
 * to 2^16 2^-24. */
void pel_plane_set(struct pel_plane *plane, const struct pel_plane_setup *setup,
                   const int32_t value[3])
{
    const struct pel_plane_setup *s = setup;
    const int32_t top = value[s->first];
    const int64_t b = (int64_t)value[s->second] - top;
    const int64_t c = (int64_t)value[s->third] - top;
    const int32_t x = pel_pixel_of(s->a.x), y = pel_pixel_of(s->a.y);
    struct pel_fraction gx, gy;
    *plane = pel_plane_level(top);
    if (s->area == 0 || (b == 0 && c == 0))
        return;
    pel_fraction_start(&gx, b * s->ac.y - c * s->ab.y, s->area);
    pel_fraction_start(&gy, c * s->ab.x - b * s->ac.x, s->area);
    pel_fraction_more(&gx, 24);
    pel_fraction_more(&gy, 24);
    plane->at +=
        gx.quotient * (uint64_t)(int64_t)(pel_pixel_center(x) - s->a.x) +
        gy.quotient * (uint64_t)(int64_t)(pel_pixel_center(y) - s->a.y);
    pel_fraction_more(&gx, 8);
    pel_fraction_more(&gy, 8);
    plane->dx = gx.quotient;
    plane->dy = gy.quotient;
    plane->at -= (uint64_t)(int64_t)x * plane->dx;
    plane->at -= (uint64_t)(int64_t)y * plane->dy;
}
