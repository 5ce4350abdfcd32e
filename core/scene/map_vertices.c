#include "mapping.h"

static pel_color vertex_color(const struct pel_frame *frame, uint32_t vertex)
{
    struct pel_texture t = frame->texture;
    pel_color color;
    for (int k = 0; k < 2; k++) {
        struct pel_texture_plane *plane = k ? &t.map.v : &t.map.u;
        plane->at = (uint64_t)pel_texture_coordinate(frame, vertex, k) << 16;
        plane->dx = plane->dy = 0;
    }
    t.base.colors(&t.base, 0, 0, 1, &color);
    return color | UINT32_C(0xFF000000);
}

const struct pel_mapping pel_map_vertices = {vertex_color, NULL, NULL};
