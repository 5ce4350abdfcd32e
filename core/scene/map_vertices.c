#include "mapping.h"

static pel_color vertex_color(const struct pel_frame *frame, uint32_t vertex)
{
    struct pel_texture t = frame->texture;
    pel_color color;
    int32_t uv[2];
    pel_mapping_place(frame, vertex, uv);
    t.map.u =
        (struct pel_texture_plane){(uint64_t)(int64_t)uv[0] * 65536, 0, 0};
    t.map.v =
        (struct pel_texture_plane){(uint64_t)(int64_t)uv[1] * 65536, 0, 0};
    t.base.colors(&t.base, 0, 0, 1, &color);
    return color | UINT32_C(0xFF000000);
}

const struct pel_mapping pel_map_vertices = {vertex_color, NULL, NULL};
