#include "../base/divide.h"
#include "../raster/triangle_sort.h"
#include "paint_texture.h"

/* The triangle from its top vertex on, in the order that makes the area
 * positive. Without area all three are the top vertex. */
struct setup {
    const struct pel_point *a, *b, *c;
    int64_t area; /* twice the area, or 1 */
};

/* n / area in 2^-32; its upper 24 bits times `distance` sub-pixels are added to
 * `at`.
 */
#if PEL_64BIT

/* Of most triangles n fits 32 bits: one division. */
static inline uint64_t gradient(const struct setup *s, int64_t n,
                                int32_t distance, uint64_t *at)
{
    struct pel_fraction g;
    if (n == (int32_t)n) {
        pel_fraction_start(&g, n * INT64_C(4294967296), s->area);
        *at += (uint64_t)(((int64_t)g.quotient >> 8) * distance);
        return g.quotient;
    }
    pel_fraction_start(&g, n, s->area);
    const uint64_t whole = g.quotient << 24;
    pel_fraction_more(&g, 32);
    *at += (whole + ((uint32_t)g.quotient >> 8)) * (uint64_t)(int64_t)distance;
    return g.quotient;
}

#else

static uint64_t gradient(const struct setup *s, int64_t n, int32_t distance,
                         uint64_t *at)
{
    struct pel_fraction g;
    pel_fraction_start(&g, n, s->area);
    pel_fraction_more(&g, 24);
    *at += g.quotient * (uint64_t)(int64_t)distance;
    pel_fraction_more(&g, 8);
    return g.quotient;
}

#endif

/* One coordinate of the picture, with the values t at a, b, c. The gradient in
 * x is nx / area with nx = (tb - ta)(c.y - a.y) - (tc - ta)(b.y - a.y), below
 * 2^58; in y alike. The gradient cut to 2^-24 leads from a to the centre of its
 * pixel, with an error of 128 2^-32 texel; a step of one pixel takes the full
 * 2^-32, off by less than 2^17 of these over the longest distance. That many
 * are added, so a coordinate never falls below a whole number that it lies on.
 */
static struct pel_texture_plane plane_of(const struct setup *s,
                                         const int32_t t[3])
{
    struct pel_texture_plane plane;
    const int64_t b = (int64_t)t[1] - t[0], c = (int64_t)t[2] - t[0];
    const int32_t x = pel_pixel_of(s->a->x), y = pel_pixel_of(s->a->y);
    plane.at = ((uint64_t)(int64_t)t[0] << 24) + 131072;
    plane.dx = gradient(s, b * (s->c->y - s->a->y) - c * (s->b->y - s->a->y),
                        pel_pixel_center(x) - s->a->x, &plane.at);
    plane.dy = gradient(s, c * (s->b->x - s->a->x) - b * (s->c->x - s->a->x),
                        pel_pixel_center(y) - s->a->y, &plane.at);
    plane.at -= (uint64_t)(int64_t)x * plane.dx;
    plane.at -= (uint64_t)(int64_t)y * plane.dy;
    return plane;
}

enum pel_status pel_texture_map_triangle(struct pel_texture_map *map,
                                         const struct pel_point v[3],
                                         const struct pel_texel_point t[3])
{
    if (!map || !v || !t)
        return PEL_ERROR_NULL;
    if (!pel_points_legal(v, 3))
        return PEL_ERROR_RANGE;
    const int64_t area = pel_area_of(v);
    const int a = pel_topmost(v), next = a < 2 ? a + 1 : 0;
    const int b = area == 0 ? a : area < 0 ? 3 - a - next : next;
    const int c = area == 0 ? a : 3 - a - b;
    const struct setup s = {&v[a], &v[b], &v[c],
                            area < 0 ? -area
                            : area   ? area
                                     : 1};
    const int32_t u[3] = {t[a].u, t[b].u, t[c].u};
    const int32_t w[3] = {t[a].v, t[b].v, t[c].v};
    map->u = plane_of(&s, u);
    map->v = plane_of(&s, w);
    return PEL_OK;
}
