#include "paint_texture.h"

/* Values of 1/256 texel are planes in 2^-32. The most that a plane can be too
 * low is added, so that a point on a border of texels stays in the upper one.
 */
void pel_texture_plane(struct pel_plane *plane,
                       const struct pel_plane_setup *setup,
                       const int32_t value[3])
{
    pel_plane_set(plane, setup, value);
    plane->at += 131072;
}

enum pel_status pel_texture_map_triangle(struct pel_texture_map *map,
                                         const struct pel_point v[3],
                                         const struct pel_texel_point t[3])
{
    struct pel_plane_setup setup;
    if (!map || !v || !t)
        return PEL_ERROR_NULL;
    if (!pel_corners_legal(v))
        return PEL_ERROR_RANGE;
    const int32_t right[3] = {t[0].u, t[1].u, t[2].u};
    const int32_t down[3] = {t[0].v, t[1].v, t[2].v};
    pel_plane_start(&setup, v);
    pel_texture_plane(&map->u, &setup, right);
    pel_texture_plane(&map->v, &setup, down);
    return PEL_OK;
}
