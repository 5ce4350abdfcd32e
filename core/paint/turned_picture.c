#include "turned_picture.h"

#include "../base/divide.h"
#include "../base/trig.h"
#include "../raster/triangle.h"

/* floor(c 2^33 / scale), of a cosine c in 2^-15: texels a pixel in 2^-32. At
 * most 2^48 / 2^12 = 2^36. */
static int64_t texels_a_pixel(int32_t c, int32_t scale)
{
    int64_t rest = c * (INT64_C(1) << 33);
    return pel_divide_64(&rest, scale);
}

/* The plane that is `value`, 1/256 texel, at the point `at`. |at - centre| <
 * 2^24, so that the products are below 2^60. */
static void set_plane(struct pel_plane *plane, int64_t dx, int64_t dy,
                      struct pel_point at, int32_t value)
{
    const uint64_t x = pel_times((uint64_t)dx, 128 - at.x);
    const uint64_t y = pel_times((uint64_t)dy, 128 - at.y);
    const int64_t offset = (int64_t)(x + y) >> 8;
    plane->dx = (uint64_t)dx;
    plane->dy = (uint64_t)dy;
    plane->at = (uint64_t)(value * (INT64_C(1) << 24) + offset);
}

/* The corner (u, v), 1/256 texel from the pivot: below 2^25, so that the
 * products are below 2^50. False: it is out of range. */
static bool set_corner(struct pel_point *corner,
                       const struct pel_turned_picture *p, int32_t u, int32_t v)
{
    const int64_t x = ((int64_t)u * p->scale + 32768) >> 16;
    const int64_t y = ((int64_t)v * p->scale + 32768) >> 16;
    if (pel_size_of(x) >> 23 || pel_size_of(y) >> 23)
        return false;
    *corner = pel_turned(
        (struct pel_point){p->at.x + (int32_t)x, p->at.y + (int32_t)y}, p->at,
        p->turn);
    return pel_point_legal(*corner);
}

static bool set_corners(struct pel_point v[4],
                        const struct pel_turned_picture *p, int32_t width,
                        int32_t height)
{
    const int32_t left = -p->pivot.u, top = -p->pivot.v;
    const int32_t right = PEL_PX(width) + left, bottom = PEL_PX(height) + top;
    return set_corner(&v[0], p, left, top) &&
           set_corner(&v[1], p, right, top) &&
           set_corner(&v[2], p, right, bottom) &&
           set_corner(&v[3], p, left, bottom);
}

static void set_map(struct pel_texture_map *map,
                    const struct pel_turned_picture *p)
{
    const struct pel_point d = pel_direction((uint16_t)p->turn);
    const int64_t along = texels_a_pixel(d.x, p->scale);
    const int64_t across = texels_a_pixel(d.y, p->scale);
    set_plane(&map->u, along, across, p->at, p->pivot.u);
    set_plane(&map->v, -across, along, p->at, p->pivot.v);
}

enum pel_status pel_turned_picture_draw(const struct pel_surface *surface,
                                        const struct pel_turned_picture *p)
{
    struct pel_texture texture;
    struct pel_texture_map map;
    struct pel_point v[4];
    if (!surface || !p)
        return PEL_ERROR_NULL;
    if (p->scale < 4096 || p->scale > 1 << 24 || !pel_point_legal(p->at) ||
        pel_size_of(p->pivot.u) >> 24 || pel_size_of(p->pivot.v) >> 24)
        return PEL_ERROR_RANGE;
    set_map(&map, p);
    const enum pel_status status =
        (p->bilinear ? pel_texture_init_bilinear
                     : pel_texture_init_nearest)(&texture, &p->texels, &map);
    if (status != PEL_OK)
        return status;
    if (!set_corners(v, p, texture.width, texture.height))
        return PEL_ERROR_RANGE;
    const struct pel_point half[3] = {v[2], v[3], v[0]};
    pel_triangle(surface, v, &texture.base.paint);
    pel_triangle(surface, half, &texture.base.paint);
    return PEL_OK;
}
