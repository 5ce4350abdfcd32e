#include "mapping.h"

static pel_color vertex_color(const struct pel_frame *frame, uint32_t vertex)
{
    struct pel_texture t = frame->texture;
    pel_color color;
    int32_t uv[2];
    pel_mapping_place(frame, vertex, uv);
    t.map.u.dx = 65536;
    t.map.v.dy = 65536;
    t.base.colors(&t.base, uv[0], uv[1], 1, &color);
    return color | UINT32_C(0xFF000000);
}

const struct pel_mapping pel_map_vertices = {vertex_color, NULL, NULL};
