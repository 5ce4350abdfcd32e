#include "mesh.h"

#include <math.h>
#include <string.h>

/* Adds a face's normal, of the length of twice its area, to its corners. */
static void add_face(struct mesh *mesh, const uint32_t index[3])
{
    struct mesh_vertex *v[3];
    double a[3], b[3];
    for (int k = 0; k < 3; k++)
        v[k] = &mesh->vertex[index[k]];
    for (int k = 0; k < 3; k++) {
        a[k] = v[1]->position[k] - v[0]->position[k];
        b[k] = v[2]->position[k] - v[0]->position[k];
    }
    const double n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]};
    for (int corner = 0; corner < 3; corner++)
        for (int k = 0; k < 3; k++)
            v[corner]->normal[k] += n[k];
}

static void normalise(double n[3])
{
    double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 3; k++)
        n[k] = length > 0 ? n[k] / length : 0;
}

void mesh_normals(struct mesh *mesh)
{
    for (uint32_t i = 0; i < mesh->vertices; i++)
        memset(mesh->vertex[i].normal, 0, sizeof(mesh->vertex[i].normal));
    for (uint32_t i = 0; i < mesh->triangles; i++)
        add_face(mesh, mesh->triangle[i]);
    for (uint32_t i = 0; i < mesh->vertices; i++)
        normalise(mesh->vertex[i].normal);
    mesh->has_normals = true;
}
