#include "sim/mesh/mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/mesh/vector.h"

/* A corner of a triangle: its new vertex, which has the normal of the face, of
 * the length of twice its area, and gets `mean`. */
struct corner {
    struct mesh_vertex *vertex;
    double mean[3];
};

void mesh_facet(const struct mesh *mesh, const uint32_t index[3],
                double normal[3])
{
    const double *corner = mesh->vertex[index[0]].position;
    double a[3], b[3];
    vector_subtract(mesh->vertex[index[1]].position, corner, a);
    vector_subtract(mesh->vertex[index[2]].position, corner, b);
    vector_cross(a, b, normal);
}

static int compare_places(const void *left, const void *right)
{
    const struct mesh_vertex *a = ((const struct corner *)left)->vertex;
    const struct mesh_vertex *b = ((const struct corner *)right)->vertex;
    for (int k = 0; k < 3; k++)
        if (a->position[k] < b->position[k] || a->position[k] > b->position[k])
            return a->position[k] < b->position[k] ? -1 : 1;
    return 0;
}

/* The means of n corners at one place, of the faces that are turned by the
 * angle of that cosine at most. */
static void set_means(struct corner *corner, uint32_t n, double cosine)
{
    for (uint32_t i = 0; i < n; i++) {
        double *mean = corner[i].mean;
        const double *own = corner[i].vertex->normal;
        for (uint32_t j = 0; j < n; j++) {
            const double *other = corner[j].vertex->normal;
            if (vector_dot(own, other) >=
                cosine * vector_length(own) * vector_length(other))
                for (int k = 0; k < 3; k++)
                    mean[k] += other[k];
        }
        vector_normalise(mean);
    }
}

/* Gives every corner a vertex of its own. */
static bool split(struct mesh *mesh)
{
    const uint32_t n = 3 * mesh->triangles;
    struct mesh_vertex *vertex = malloc(n * sizeof(*vertex));
    if (!vertex)
        return false;
    for (uint32_t i = 0; i < n; i++) {
        uint32_t *index = &mesh->triangle[i / 3][i % 3];
        vertex[i] = mesh->vertex[*index];
        *index = i;
    }
    free(mesh->vertex);
    mesh->vertex = vertex;
    mesh->vertices = n;
    for (uint32_t i = 0; i < mesh->parts; i++)
        mesh->part[i].vertices = 3 * mesh->part[i].triangles;
    return true;
}

bool mesh_normals(struct mesh *mesh, double crease)
{
    const uint32_t n = 3 * mesh->triangles, joined = mesh->joined;
    const double cosine = cos(fmin(crease, 180) * atan(1) / 45) - 1e-9;
    struct corner *corner = calloc(n, sizeof(*corner));
    if (!corner || !split(mesh)) {
        free(corner);
        return message_error("no memory for the normals of %u triangles",
                             mesh->triangles);
    }
    for (uint32_t i = 0; i < n; i++) {
        corner[i].vertex = &mesh->vertex[i];
        mesh_facet(mesh, mesh->triangle[i / 3], mesh->vertex[i].normal);
    }
    qsort(corner, n, sizeof(*corner), compare_places);
    for (uint32_t i = 0, some; i < n; i += some) {
        for (some = 1; i + some < n; some++)
            if (compare_places(&corner[i], &corner[i + some]) != 0)
                break;
        set_means(&corner[i], some, some > 4096 ? -2 : cosine);
    }
    for (uint32_t i = 0; i < n; i++)
        memcpy(corner[i].vertex->normal, corner[i].mean,
               sizeof(corner[i].mean));
    free(corner);
    mesh->has_normals = mesh->made_normals = true;
    const bool done = mesh_weld(mesh);
    mesh->joined = joined;
    return done;
}
