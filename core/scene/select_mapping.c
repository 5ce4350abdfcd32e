#include "../base/divide.h"
#include "select.h"
#include "work.h"

/* 1/256 texel: what corners in 1/256 texel and the exact mapping are off by. */
enum { MAPPING_ERROR = 3 };

/* True when u (far - near) <= 4 room near, u the texels of the triangle: both
 * sides below 2^62. */
static bool is_affine(const struct pel_texture_corner corner[3], int32_t near,
                      int32_t far, int32_t room)
{
    int64_t texels = 0;
    for (int i = 0; i < 6; i++) {
        const int64_t u = pel_size_of(corner[i % 3].uv[i / 3] -
                                      corner[(i + 1) % 3].uv[i / 3]);
        texels = u > texels ? u : texels;
    }
    return (texels >> 8) + 1 <= INT32_MAX &&
           pel_long_product((int32_t)(texels >> 8) + 1, far - near) <=
               pel_long_product(near, 4 * room);
}

/* A gradient in 2^-16 of the largest w, rounded up; at most 2^17. */
static uint64_t slope_of(const struct pel_plane *plane)
{
    const uint64_t slope = (uint64_t)pel_size_of((int64_t)plane->dx) >> 38;
    return slope < 131071 ? slope + 1 : 131072;
}

/* In a span of n pixels w is `near` or more and changes by a = n |dw| at most,
 * u w by n |d(uw)|: so u, up to 3/2 where spans are divided, changes by
 * (n |d(uw)| + 3/2 a) / near or less, and r - 1 is a / near or less. */
static bool is_span(const struct pel_divided_texture *p, int bits,
                    uint64_t least, int32_t room)
{
    const uint64_t a = slope_of(&p->by.w) << bits;
    if (2 * a > least)
        return false;
    const uint64_t near = least - a;
    for (int k = 0; k < 2; k++) {
        const uint64_t change = (slope_of(&p->uv[k].plane) << bits) + a + a / 2;
        /* change a 2^extent texels 2^-16 <= 4 room near^2, room 2^-8 */
        const uint64_t most = (near * near * (uint32_t)room >> 4 << 14);
        if (change * a > most >> p->uv[k].extent)
            return false;
    }
    return true;
}

static const struct pel_color_paint *surface(struct pel_frame *frame)
{
    struct pel_divided_texture *p = &frame->work->perspective;
    const int32_t room =
        pel_max(pel_min(frame->scene->texel_tolerance, 65536), 0) -
        MAPPING_ERROR;
    struct pel_texture_corner c[3];
    pel_frame_texels(frame, c);
    const int32_t near = pel_min(pel_min(c[0].z, c[1].z), c[2].z);
    const int32_t far = pel_max(pel_max(c[0].z, c[1].z), c[2].z);
    if (room > 0 && is_affine(c, near, far, room))
        return pel_frame_affine(frame);
    pel_divided_texture_init(p, &frame->work->texture, pel_frame_setup(frame),
                             c, room > 0 ? PEL_SPAN_MAX : PEL_SPAN_EXACT);
    /* The least w is near / far. */
    const uint64_t least =
        pel_divide((uint64_t)(uint32_t)near << 16, (uint32_t)far);
    while (p->by.span > 0 && !is_span(p, p->by.span, least, room))
        p->by.span--;
    return &p->by.base;
}

const struct pel_mapping pel_map_chosen = {NULL, surface, pel_frame_modulate};
