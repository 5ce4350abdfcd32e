#include "sim/mesh/mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"

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

static int compare_places(const void *left, const void *right)
{
    const struct mesh_vertex *const *a = left, *const *b = right;
    for (int k = 0; k < 3; k++) {
        const double p = (*a)->position[k], q = (*b)->position[k];
        if (p < q || p > q)
            return p < q ? -1 : 1;
    }
    return 0;
}

/* Gives n vertices at one place the sum of their normals. */
static void share(struct mesh_vertex **vertex, uint32_t n)
{
    double sum[3] = {0, 0, 0};
    for (uint32_t i = 0; i < n; i++)
        for (int k = 0; k < 3; k++)
            sum[k] += vertex[i]->normal[k];
    normalise(sum);
    for (uint32_t i = 0; i < n; i++)
        memcpy(vertex[i]->normal, sum, sizeof(sum));
}

bool mesh_normals(struct mesh *mesh)
{
    struct mesh_vertex **order = malloc(mesh->vertices * sizeof(*order));
    if (!order)
        return message_error("no memory for the normals of %u vertices",
                             mesh->vertices);
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        order[i] = &mesh->vertex[i];
        memset(order[i]->normal, 0, sizeof(order[i]->normal));
    }
    for (uint32_t i = 0; i < mesh->triangles; i++)
        add_face(mesh, mesh->triangle[i]);
    qsort(order, mesh->vertices, sizeof(*order), compare_places);
    for (uint32_t i = 0, n; i < mesh->vertices; i += n) {
        for (n = 1; i + n < mesh->vertices; n++)
            if (compare_places(&order[i], &order[i + n]) != 0)
                break;
        share(&order[i], n);
    }
    free(order);
    mesh->has_normals = true;
    return true;
}
