#include "divided.h"

#include "../base/divide.h"
#include "vector.h"

struct pel_plane *pel_divided_planes(const struct pel_divided *divided)
{
    return (struct pel_plane *)((uintptr_t)divided->inner + divided->planes);
}

/* origin 2^16 + part 2^(extent - 14), in 2^-24 units, plus its largest error,
 * five of its last bits: a point on a border of texels stays in the upper one.
 * |part| <= 3/2 2^30. */
static uint64_t value_of(int64_t origin, int32_t part, int extent)
{
    return ((uint64_t)origin << 16) +
           (uint64_t)pel_scale_down((int64_t)part + 8, 14 - extent);
}

/* Sets `at` of the planes to the values there and `dx` to what `at` was. False,
 * and any values, where w is not above 0 or a value would be out of range:
 * outside of the triangle. All are shifted so that w fills 32 bits and values
 * stand two bits lower: a quotient is too low by less than 5 2^-30. */
static bool divide(const struct pel_divided *d, int32_t x, int32_t y)
{
    const struct pel_divided_value *v = (const void *)(d + 1);
    struct pel_plane *line = pel_divided_planes(d);
    const int64_t w = (int64_t)pel_plane_at(&d->w, x, y);
    bool legal = w >= INT64_C(1) << 26 && w >> 55 == 0;
    const int shift = legal ? pel_bits_of((uint64_t)w) - 26 : 0;
    const uint32_t inverse =
        legal ? pel_divide((UINT64_C(1) << 63) - 1, (uint32_t)(w * 64 >> shift))
              : 0;
    for (int k = 0; k < d->values; k++, v++) {
        const int64_t n = (int64_t)pel_plane_at(&v->plane, x, y);
        int32_t part = 0;
        legal = legal && pel_size_of(n) <= w + (w >> 1);
        if (legal)
            part = pel_scaled((int32_t)(n * 16 >> shift),
                              (int32_t)(inverse >> 1), 30);
        line[k].dx = line[k].at;
        line[k].at = value_of(v->origin, part, v->extent);
    }
    return legal;
}

/* Makes lines between the ends of the span that begins at pixel `begin`, for
 * those from x on. */
static void set_lines(const struct pel_divided *d, int32_t x, int32_t begin)
{
    struct pel_plane *p = pel_divided_planes(d);
    for (int k = 0; k < d->values; k++, p++) {
        p->dx = (uint64_t)((int64_t)(p->dx - p->at) >> d->span);
        p->at += (uint64_t)(x - begin) * p->dx;
    }
}

/* Sets the planes from pixel (x, y) on, and returns for how many they hold: up
 * to the end of the span, or one, where an end of it lies too far outside of
 * the triangle. */
static int32_t find(const struct pel_divided *d, int32_t x, int32_t y)
{
    const int32_t size = (int32_t)(UINT32_C(1) << d->span);
    const int32_t begin = x & -size;
    if (size > 1 && divide(d, begin + size, y) && divide(d, begin, y)) {
        set_lines(d, x, begin);
        if (!d->is_near || d->is_near(d, begin, y))
            return begin + size - x;
    }
    divide(d, x, y);
    return 1;
}

void pel_divided_colors(const struct pel_color_paint *paint, int32_t x,
                        int32_t y, int32_t n, pel_color *out)
{
    const struct pel_divided *d = (const void *)paint;
    for (int32_t part; n > 0; n -= part, x += part, out += part) {
        part = pel_min(find(d, x, y), n);
        d->inner->colors(d->inner, 0, 0, part, out);
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

void pel_divided_init(struct pel_divided *divided,
                      const struct pel_color_paint *inner,
                      const struct pel_plane_setup *setup, const int32_t z[3],
                      int32_t span)
{
    const int32_t near = pel_min(pel_min(z[0], z[1]), z[2]);
    pel_color_paint_init(&divided->base, pel_divided_colors, inner->opaque);
    divided->inner = inner;
    divided->is_near = NULL;
    for (int i = 0; i < 3; i++) {
        const uint32_t far = (uint32_t)z[i];
        divided->corner[i] = (int32_t)pel_divide(
            ((uint64_t)(uint32_t)near << 30) + far / 2, far);
    }
    divided->span =
        thin(setup) ? 0 : (uint8_t)(pel_bits_of((uint64_t)span | 1) - 1);
    pel_plane_set(&divided->w, setup, divided->corner);
}

/* Differences from the first corner, with 2^extent above the largest; of more
 * than 31 bits, the first ones. */
void pel_divided_set(struct pel_divided_value *value,
                     const struct pel_divided *divided,
                     const struct pel_plane_setup *setup,
                     const int64_t corner[3])
{
    int64_t offset[3];
    int32_t part[3];
    value->origin = corner[setup->first];
    for (int i = 0; i < 3; i++)
        offset[i] = corner[i] - value->origin;
    const int extent = pel_bits_of(pel_vector_bound(offset));
    const int cut = pel_max(extent - 31, 0);
    value->extent = (uint8_t)extent;
    for (int i = 0; i < 3; i++)
        part[i] = pel_scaled((int32_t)(offset[i] >> cut), divided->corner[i],
                             extent - cut);
    pel_plane_set(&value->plane, setup, part);
}

void pel_divided_texture_init(struct pel_divided_texture *paint,
                              struct pel_texture *texture,
                              const struct pel_plane_setup *setup,
                              const struct pel_texture_corner corner[3],
                              int32_t span)
{
    const int32_t z[3] = {corner[0].z, corner[1].z, corner[2].z};
    struct pel_divided *d = &paint->by;
    texture->map.u.dy = texture->map.v.dy = 0;
    pel_divided_init(d, &texture->base, setup, z, span);
    d->values = 2;
    d->planes = offsetof(struct pel_texture, map);
    for (int k = 0; k < 2; k++) {
        const int64_t uv[3] = {corner[0].uv[k], corner[1].uv[k],
                               corner[2].uv[k]};
        pel_divided_set(&paint->uv[k], d, setup, uv);
    }
}
