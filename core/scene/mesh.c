#include "mesh.h"

#include "vector.h"

/* C99 wants one copy of inline functions that are not static. */
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
                              .indices32 = asset->indices32,
                              .part = asset->part,
                              .parts = asset->parts};
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

int32_t pel_quantization_limit(const struct pel_quantization *q)
{
    const uint32_t world = PEL_LENGTH_MAX / 65536;
    if (q->shift > 16)
        return INT32_MAX;
    return (int32_t)(q->shift < 0 ? world >> -q->shift : world << q->shift);
}

static bool positions_legal(const struct pel_mesh *m)
{
    const int32_t limit = pel_quantization_limit(&m->position);
    for (uint32_t i = 0; limit < INT32_MAX && i < m->vertices; i++)
        for (int k = 0; k < 3; k++)
            if (pel_magnitude(pel_quantization_value(
                    &m->position, k, m->positions[i][k])) > limit)
                return false;
    return true;
}

static enum pel_status check_indices(const struct pel_mesh *m,
                                     struct pel_mesh_fault *fault)
{
    for (uint32_t i = 0; i < m->triangles; i++) {
        uint32_t corner[3];
        pel_mesh_corners(m, i, corner);
        for (int k = 0; k < 3; k++)
            if (corner[k] >= m->vertices) {
                if (fault)
                    *fault = (struct pel_mesh_fault){i, corner[k], 0};
                return PEL_ERROR_RANGE;
            }
    }
    return PEL_OK;
}

enum pel_status pel_mesh_check(const struct pel_mesh *mesh,
                               struct pel_mesh_fault *fault)
{
    uint32_t part;
    if (!mesh || !mesh->positions ||
        !mesh->indices8 + !mesh->indices16 + !mesh->indices32 != 2 ||
        (mesh->parts && !mesh->part))
        return PEL_ERROR_NULL;
    if (!sizes_legal(mesh) || !positions_legal(mesh))
        return PEL_ERROR_SIZE;
    part = pel_mesh_wrong_part(mesh->part, mesh->parts, mesh->vertices,
                               mesh->triangles);
    if (part < mesh->parts) {
        if (fault)
            *fault = (struct pel_mesh_fault){0, 0, part};
        return PEL_ERROR_SIZE;
    }
    return check_indices(mesh, fault);
}

size_t pel_mesh_normals_scratch_size(const struct pel_mesh *mesh)
{
    return PEL_MESH_NORMALS_SCRATCH_SIZE(mesh->vertices);
}

void pel_mesh_facet(const struct pel_mesh *m, const uint32_t corner[3],
                    int64_t normal[3])
{
    const int16_t *a = m->positions[corner[0]];
    const int16_t *b = m->positions[corner[1]];
    const int16_t *c = m->positions[corner[2]];
    int32_t ab[3], ac[3];
    for (int k = 0; k < 3; k++) {
        ab[k] = b[k] - a[k];
        ac[k] = c[k] - a[k];
    }
    pel_cross(ab, ac, normal);
}

/* A vertex has less than 2^28 faces with three corners each. */
static void add_face(const struct pel_mesh *m, uint32_t triangle,
                     int64_t (*sum)[3])
{
    uint32_t corner[3];
    int64_t normal[3];
    pel_mesh_corners(m, triangle, corner);
    pel_mesh_facet(m, corner, normal);
    for (int i = 0; i < 9; i++)
        sum[corner[i / 3]][i % 3] += normal[i % 3];
}

enum pel_status pel_mesh_normals(const struct pel_mesh *mesh,
                                 int16_t (*normals)[3], void *scratch,
                                 size_t scratch_size)
{
    int64_t(*sum)[3] = scratch;
    enum pel_status status = pel_mesh_check(mesh, NULL);
    if (status != PEL_OK)
        return status;
    if (!normals || !scratch)
        return PEL_ERROR_NULL;
    if ((uintptr_t)scratch % sizeof(int64_t) ||
        scratch_size < pel_mesh_normals_scratch_size(mesh))
        return PEL_ERROR_SCRATCH;
    for (uint32_t i = 0; i < mesh->vertices; i++)
        sum[i][0] = sum[i][1] = sum[i][2] = 0;
    for (uint32_t i = 0; i < mesh->triangles; i++)
        add_face(mesh, i, sum);
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        pel_cosine unit[3];
        pel_normalize(sum[i], unit);
        for (int k = 0; k < 3; k++)
            normals[i][k] =
                (int16_t)pel_scale_down((int64_t)unit[k] * 32767, 30);
    }
    return PEL_OK;
}
