#include "paint_perspective.h"

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_perspective *p = (const void *)paint;
    struct pel_texture *t = p->texture;
    struct pel_plane line[2];
    for (int32_t part; n > 0; n -= part, x += part, out += part) {
        part = pel_min(pel_divided_lines(&p->divided, x, y, line), n);
        t->map.u.at = line[0].at;
        t->map.u.dx = line[0].dx;
        t->map.v.at = line[1].at;
        t->map.v.dx = line[1].dx;
        t->base.colors(&t->base, 0, 0, part, out);
    }
}

void pel_perspective_init(struct pel_perspective *paint,
                          struct pel_texture *texture,
                          const struct pel_plane_setup *setup,
                          const struct pel_texture_corner corner[3],
                          int32_t span)
{
    const int32_t z[3] = {corner[0].z, corner[1].z, corner[2].z};
    paint->texture = texture;
    texture->map.u.dy = texture->map.v.dy = 0;
    pel_divided_init(&paint->divided, setup, z, span);
    paint->divided.value = paint->uv;
    paint->divided.values = 2;
    for (int k = 0; k < 2; k++) {
        const int64_t uv[3] = {corner[0].uv[k], corner[1].uv[k],
                               corner[2].uv[k]};
        pel_divided_set(&paint->uv[k], &paint->divided, setup, uv);
    }
    pel_color_paint_init(&paint->base, colors, texture->base.opaque);
}
