#include "normals.h"

#include "vector.h"

size_t pel_mesh_normals_scratch_size(const struct pel_mesh *mesh)
{
    return PEL_MESH_NORMALS_SCRATCH_SIZE(mesh->vertices);
}

/* Twice the area times the normal, below 2^35; a vertex has less than 2^28
 * faces with three corners each. */
static void add_face(const struct pel_mesh *m, uint32_t triangle,
                     int64_t (*sum)[3])
{
    uint32_t corner[3];
    pel_mesh_corners(m, triangle, corner);
    const int16_t *a = m->positions[corner[0]];
    const int16_t *b = m->positions[corner[1]];
    const int16_t *c = m->positions[corner[2]];
    for (int k = 0; k < 3; k++) {
        const int i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
        const int64_t part = (int64_t)(b[i] - a[i]) * (c[j] - a[j]) -
                             (int64_t)(b[j] - a[j]) * (c[i] - a[i]);
        for (int n = 0; n < 3; n++)
            sum[corner[n]][k] += part;
    }
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
