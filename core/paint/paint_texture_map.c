#include "../base/fixed_fraction.h"
#include "paint_texture.h"
#include "../raster/triangle_sort.h"

/* The triangle from top to bottom, and where its vertices are in the picture.
 */
struct setup {
    struct pel_point a, b, c;
    int64_t area; /* twice the area, positive */
};

/* One coordinate of the picture, with the values t at a, b, c. The gradient in
 * x is nx / area with nx = (tb - ta)(c.y - a.y) - (tc - ta)(b.y - a.y), below
 * 2^58; in y alike. The anchor is the pixel of a. Where its centre lies, way
 * sub-pixels from a, is known from the gradient to 2^-24, which leaves an error
 * of 128 2^-32 texel; a step of one pixel takes the full 2^-32, off by less
 * than 2^17 of these on the longest way. That many are added, so that a
 * coordinate never falls below a whole number that it lies on. */
static struct pel_texture_plane plane_of(const struct setup *s,
                                         const int32_t t[3])
{
    struct pel_texture_plane plane;
    const int64_t b = (int64_t)t[1] - t[0], c = (int64_t)t[2] - t[0];
    const int32_t x = pel_pixel_of(s->a.x), y = pel_pixel_of(s->a.y);
    struct pel_fraction gx, gy;
    pel_fraction_start(&gx, b * (s->c.y - s->a.y) - c * (s->b.y - s->a.y),
                       s->area);
    pel_fraction_start(&gy, c * (s->b.x - s->a.x) - b * (s->c.x - s->a.x),
                       s->area);
    pel_fraction_more(&gx, 24);
    pel_fraction_more(&gy, 24);
    plane.at = ((uint64_t)(int64_t)t[0] << 24) + 131072 +
               gx.quotient * (uint64_t)(int64_t)(pel_pixel_center(x) - s->a.x) +
               gy.quotient * (uint64_t)(int64_t)(pel_pixel_center(y) - s->a.y);
    pel_fraction_more(&gx, 8);
    pel_fraction_more(&gy, 8);
    plane.dx = gx.quotient;
    plane.dy = gy.quotient;
    plane.at -= (uint64_t)(int64_t)x * plane.dx;
    plane.at -= (uint64_t)(int64_t)y * plane.dy;
    return plane;
}

/* The area from sorted vertices; b and c change places to make it positive. */
static int64_t set_area(struct setup *s, struct pel_texel_point t[3])
{
    s->area = (int64_t)(s->b.x - s->a.x) * (s->c.y - s->a.y) -
              (int64_t)(s->c.x - s->a.x) * (s->b.y - s->a.y);
    if (s->area < 0) {
        const struct pel_point b = s->b;
        const struct pel_texel_point tb = t[1];
        s->area = -s->area;
        s->b = s->c;
        s->c = b;
        t[1] = t[2];
        t[2] = tb;
    }
    return s->area;
}

/* The same place in the picture for every pixel. */
static void set_flat(struct pel_texture_map *map, struct pel_texel_point t)
{
    map->u = (struct pel_texture_plane){(uint64_t)(int64_t)t.u << 24, 0, 0};
    map->v = (struct pel_texture_plane){(uint64_t)(int64_t)t.v << 24, 0, 0};
}

enum pel_status pel_texture_map_triangle(struct pel_texture_map *map,
                                         const struct pel_point v[3],
                                         const struct pel_texel_point t[3])
{
    if (!map || !v || !t)
        return PEL_ERROR_NULL;
    if (!pel_points_legal(v, 3))
        return PEL_ERROR_RANGE;
    const struct pel_point *p[3] = {&v[0], &v[1], &v[2]};
    pel_sort3(p);
    struct setup s = {*p[0], *p[1], *p[2], 0};
    struct pel_texel_point q[3] = {t[p[0] - v], t[p[1] - v], t[p[2] - v]};
    if (set_area(&s, q) == 0) {
        set_flat(map, q[0]);
        return PEL_OK;
    }
    const int32_t u[3] = {q[0].u, q[1].u, q[2].u};
    const int32_t w[3] = {q[0].v, q[1].v, q[2].v};
    map->u = plane_of(&s, u);
    map->v = plane_of(&s, w);
    return PEL_OK;
}
