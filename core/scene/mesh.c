#include "mesh.h"

/* The copies of inline functions (vector.h). */
void pel_mesh_corners(const struct pel_mesh *mesh, uint32_t triangle,
                      uint32_t corner[3]);
void pel_mesh_normal(const struct pel_mesh *mesh, uint32_t vertex,
                     int32_t normal[3]);

void pel_mesh_of_asset(struct pel_mesh *mesh,
                       const struct pel_mesh_asset *asset)
{
    *mesh = (struct pel_mesh){.vertices = asset->vertices,
                              .triangles = asset->triangles,
                              .position = asset->position,
                              .texture = asset->texture,
                              .positions = asset->positions,
                              .normals8 = asset->normals8,
                              .normals16 = asset->normals16,
                              .uv = asset->uv,
                              .colors = asset->colors,
                              .indices16 = asset->indices16,
                              .indices32 = asset->indices32};
}

static bool quantum_legal(const struct pel_quantization *q)
{
    return pel_quantization_legal(q) && q->shift >= PEL_MESH_SHIFT_MIN &&
           q->shift <= PEL_MESH_SHIFT_MAX;
}

static bool sizes_legal(const struct pel_mesh *m)
{
    /* Lists of 24 bytes a vertex and 8 a triangle fit 32-bit sizes. */
    const uint32_t limit = UINT32_C(1) << 26;
    return m->vertices >= 1 && m->vertices <= limit && m->triangles <= limit &&
           !(m->normals8 && m->normals16) && quantum_legal(&m->position) &&
           (!m->uv || quantum_legal(&m->texture));
}

static enum pel_status check_indices(const struct pel_mesh *m,
                                     struct pel_mesh_fault *fault)
{
    struct pel_mesh_fault at = {0, 0};
    uint32_t corner[3];
    for (; at.triangle < m->triangles; at.triangle++) {
        pel_mesh_corners(m, at.triangle, corner);
        for (int k = 0; k < 3; k++) {
            at.index = corner[k];
            if (at.index < m->vertices)
                continue;
            if (fault)
                *fault = at;
            return PEL_ERROR_RANGE;
        }
    }
    return PEL_OK;
}

enum pel_status pel_mesh_check(const struct pel_mesh *mesh,
                               struct pel_mesh_fault *fault)
{
    if (!mesh || !mesh->positions ||
        !mesh->indices8 + !mesh->indices16 + !mesh->indices32 != 2)
        return PEL_ERROR_NULL;
    if (!sizes_legal(mesh))
        return PEL_ERROR_SIZE;
    return check_indices(mesh, fault);
}
