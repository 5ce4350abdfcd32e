#include "paint_perspective.h"

#include "../base/divide.h"
#include "vector.h"

/* origin 2^16 + part 2^(extent - 14), in 2^-32 texels, plus its largest error,
 * five of its last bits: a point on a border of texels stays in the upper one.
 * |part| <= 3/2 2^30. */
static uint64_t coordinate(int64_t origin, int32_t part, int extent)
{
    return ((uint64_t)origin << 16) +
           (uint64_t)pel_scale_down((int64_t)part + 8, 14 - extent);
}

/* The point in the texture, 2^-32 texels. False, and any point, where w is not
 * above 0 or u or v would be out of range: outside of the triangle. All are
 * shifted so that w fills 32 bits and u and v stand two bits lower: a quotient
 * is too low by less than 5 2^-30. */
static bool divide(const struct pel_perspective *p, int32_t x, int32_t y,
                   uint64_t position[2])
{
    const int64_t w = (int64_t)pel_plane_at(&p->w, x, y);
    bool legal = w >= INT64_C(1) << 26 && w >> 55 == 0;
    const int shift = legal ? pel_bits_of((uint64_t)w) - 26 : 0;
    const uint32_t inverse =
        legal ? pel_divide((UINT64_C(1) << 63) - 1, (uint32_t)(w * 64 >> shift))
              : 0;
    for (int k = 0; k < 2; k++) {
        const int64_t n = (int64_t)pel_plane_at(&p->uv[k], x, y);
        int32_t part = 0;
        legal = legal && pel_size_of(n) <= w + (w >> 1);
        if (legal)
            part = pel_scaled((int32_t)(n * 16 >> shift),
                              (int32_t)(inverse >> 1), 30);
        position[k] = coordinate(p->origin[k], part, p->extent[k]);
    }
    return legal;
}

/* Linear over a span, from pixel x of it on. */
static PEL_NOINLINE_32 void set_line(struct pel_plane *line, uint64_t from,
                                     uint64_t to, int span, int32_t x)
{
    line->dx = (uint64_t)((int64_t)(to - from) >> span);
    line->at = from + (uint64_t)x * line->dx;
}

/* Sets the map of the pixels from x on, as pixels 0, 1 ..., and returns their
 * number: up to the end of the span, or one, where an end of it cannot be
 * divided. */
static int32_t start(const struct pel_perspective *p, int32_t x, int32_t y,
                     struct pel_texture_map *map)
{
    const int32_t n = (int32_t)(UINT32_C(1) << p->span);
    int32_t begin = x & -n, end = begin + n;
    uint64_t at[2], to[2];
    if (n == 1 || !divide(p, begin, y, at) || !divide(p, end, y, to)) {
        divide(p, x, y, at);
        to[0] = at[0];
        to[1] = at[1];
        begin = x;
        end = x + 1;
    }
    set_line(&map->u, at[0], to[0], p->span, x - begin);
    set_line(&map->v, at[1], to[1], p->span, x - begin);
    return end - x;
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_perspective *p = (const void *)paint;
    struct pel_texture *t = p->texture;
    for (int32_t part; n > 0; n -= part, x += part, out += part) {
        part = pel_min(start(p, x, y, &t->map), n);
        t->base.colors(&t->base, 0, 0, part, out);
    }
}

/* True for a triangle that is thinner than a pixel, whose gradients may wrap
 * before the end of a span: its area takes fewer bits than 256 times twice a
 * side. Other gradients are below 2^31 a pixel. */
static bool thin(const struct pel_plane_setup *s)
{
    uint32_t sides = 0; /* those that meet in a */
    for (int i = 0; i < 3; i++)
        if (i != s->first)
            sides |= (uint32_t)pel_size_of(s->right[i]) |
                     (uint32_t)pel_size_of(s->down[i]);
    return pel_bits_of(s->area) < pel_bits_of(sides) + 10;
}

/* The plane of the differences of u or v from the first corner, times w
 * 2^-extent, with 2^extent above the largest; of more than 31 bits, the first
 * ones. */
static PEL_NOINLINE_32 void set_plane(struct pel_perspective *p, int k,
                                      const struct pel_plane_setup *setup,
                                      const struct pel_texture_corner corner[3],
                                      const int32_t w[3])
{
    int64_t offset[3];
    int32_t value[3];
    p->origin[k] = corner[setup->first].uv[k];
    for (int i = 0; i < 3; i++)
        offset[i] = corner[i].uv[k] - p->origin[k];
    const int extent = pel_bits_of(pel_vector_bound(offset));
    const int cut = pel_max(extent - 31, 0);
    p->extent[k] = (uint8_t)extent;
    for (int i = 0; i < 3; i++)
        value[i] = pel_scaled((int32_t)(offset[i] >> cut), w[i], extent - cut);
    pel_plane_set(&p->uv[k], setup, value);
}

void pel_perspective_init(struct pel_perspective *paint,
                          struct pel_texture *texture,
                          const struct pel_plane_setup *setup,
                          const struct pel_texture_corner corner[3],
                          int32_t span)
{
    const int32_t near =
        pel_min(pel_min(corner[0].z, corner[1].z), corner[2].z);
    int32_t w[3];
    for (int i = 0; i < 3; i++) {
        const uint32_t z = (uint32_t)corner[i].z;
        w[i] = (int32_t)pel_divide(((uint64_t)(uint32_t)near << 30) + z / 2, z);
    }
    paint->texture = texture;
    paint->span =
        thin(setup) ? 0 : (uint8_t)(pel_bits_of((uint64_t)span | 1) - 1);
    pel_plane_set(&paint->w, setup, w);
    for (int k = 0; k < 2; k++)
        set_plane(paint, k, setup, corner, w);
    pel_color_paint_init(&paint->base, colors, texture->base.opaque);
}
