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
 * angle of that cosine at most: each against each. */
static void set_few_means(struct corner *corner, uint32_t n, double cosine)
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

/* A face of many at one place; its direction in 2^-40, so that faces of one
 * plane are alike. */
struct facing {
    double unit[3], normal[3];
};

/* A tree over faces, nodes as in a heap: the children of node i are 2 i + 1 and
 * 2 i + 2. The faces of a node are within the angle `radius` of its axis; all
 * are the same way in a leaf. */
struct node {
    double axis[3], radius, sum[3];
    bool is_leaf;
};

struct tree {
    struct node *node;
    double cosine, angle; /* of the faces that are taken */
};

static double angle_between(const double a[3], const double b[3])
{
    return acos(fmax(-1, fmin(vector_dot(a, b), 1)));
}

static int by_x(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static int by_y(const void *a, const void *b)
{
    return by_x((const double *)a + 1, (const double *)b + 1);
}

static int by_z(const void *a, const void *b)
{
    return by_x((const double *)a + 2, (const double *)b + 2);
}

/* Sorts along the axis on which they differ most. False when they do not. */
static bool sort(struct facing *face, size_t n)
{
    static int (*const by[3])(const void *, const void *) = {by_x, by_y, by_z};
    double extent[3];
    int widest = 0;
    for (int k = 0; k < 3; k++) {
        double low = 1, high = -1;
        for (size_t i = 0; i < n; i++) {
            low = fmin(low, face[i].unit[k]);
            high = fmax(high, face[i].unit[k]);
        }
        extent[k] = high - low;
        widest = extent[k] > extent[widest] ? k : widest;
    }
    if (extent[widest] > 0)
        qsort(face, n, sizeof *face, by[widest]);
    return extent[widest] > 0;
}

static void add(double to[3], const double from[3])
{
    for (int k = 0; k < 3; k++)
        to[k] += from[k];
}

static void build(struct tree *tree, size_t at, struct facing *face, size_t n)
{
    struct node *node = &tree->node[at];
    *node = (struct node){.is_leaf = !sort(face, n)};
    for (size_t i = 0; i < n; i++)
        add(node->axis, face[i].unit);
    vector_normalise(node->axis);
    for (size_t i = 0; i < n; i++)
        node->radius =
            fmax(node->radius, angle_between(node->axis, face[i].unit));
    for (size_t i = 0; node->is_leaf && i < n; i++)
        add(node->sum, face[i].normal);
    if (node->is_leaf)
        return;
    build(tree, 2 * at + 1, face, n / 2);
    build(tree, 2 * at + 2, face + n / 2, n - n / 2);
    add(node->sum, tree->node[2 * at + 1].sum);
    add(node->sum, tree->node[2 * at + 2].sum);
}

/* Adds those faces of a node that are turned from `own` by the angle at most;
 * true for all of them. Which ones these are is all that the sum depends on, so
 * corners with the same faces have the same normal to the last bit, and are
 * joined. */
static bool add_near(const struct tree *tree, size_t at, const double own[3],
                     double sum[3])
{
    const double margin = 1e-7; /* of acos */
    const struct node *node = &tree->node[at];
    const double angle = angle_between(own, node->axis);
    double part[3] = {0};
    if (angle - node->radius > tree->angle + margin)
        return false;
    bool all = angle + node->radius < tree->angle - margin;
    if (!all && node->is_leaf && vector_dot(own, node->axis) < tree->cosine)
        return false;
    if (!all && !node->is_leaf) {
        all = add_near(tree, 2 * at + 1, own, part);
        all = add_near(tree, 2 * at + 2, own, part) && all;
        if (!all)
            add(sum, part);
        if (!all)
            return false;
    }
    add(sum, node->sum);
    return true;
}

static void set_unit(double to[3], const double from[3])
{
    memcpy(to, from, 3 * sizeof *to);
    vector_normalise(to);
    for (int k = 0; k < 3; k++)
        to[k] = ldexp(rint(ldexp(to[k], 40)), -40);
}

/* The same means of many corners, in the time of n sqrt n at worst where it is
 * n^2 by the way above. A face without area adds nothing, and takes all. False
 * when memory is short. */
static bool set_many_means(struct corner *corner, uint32_t n, double cosine)
{
    struct tree tree = {calloc(4 * (size_t)n, sizeof *tree.node), cosine,
                        acos(fmax(cosine, -1))};
    struct facing *face = malloc(n * sizeof *face);
    size_t faces = 0;
    const bool done = tree.node && face;
    for (uint32_t i = 0; done && i < n; i++) {
        const double *normal = corner[i].vertex->normal;
        if (vector_length(normal) > 0) {
            set_unit(face[faces].unit, normal);
            memcpy(face[faces++].normal, normal, sizeof face->normal);
        }
    }
    if (done && faces > 0)
        build(&tree, 0, face, faces);
    for (uint32_t i = 0; done && faces > 0 && i < n; i++) {
        double own[3];
        if (vector_length(corner[i].vertex->normal) > 0) {
            set_unit(own, corner[i].vertex->normal);
            add_near(&tree, 0, own, corner[i].mean);
        } else
            add(corner[i].mean, tree.node->sum);
        vector_normalise(corner[i].mean);
    }
    free(tree.node);
    free(face);
    return done;
}

/* Corners with the same place follow each other. */
static bool set_means(struct corner *corner, uint32_t n, double cosine)
{
    enum { FEW = 64 };
    bool done = true;
    for (uint32_t i = 0, some; done && i < n; i += some) {
        for (some = 1; i + some < n; some++)
            if (compare_places(&corner[i], &corner[i + some]) != 0)
                break;
        if (some <= FEW)
            set_few_means(&corner[i], some, cosine);
        else
            done = set_many_means(&corner[i], some, cosine);
    }
    return done;
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
    bool done = corner && split(mesh);
    for (uint32_t i = 0; done && i < n; i++) {
        corner[i].vertex = &mesh->vertex[i];
        mesh_facet(mesh, mesh->triangle[i / 3], mesh->vertex[i].normal);
    }
    if (done) {
        qsort(corner, n, sizeof(*corner), compare_places);
        done = set_means(corner, n, cosine);
    }
    for (uint32_t i = 0; done && i < n; i++)
        memcpy(corner[i].vertex->normal, corner[i].mean,
               sizeof(corner[i].mean));
    free(corner);
    if (!done)
        return message_error("no memory for the normals of %u triangles",
                             mesh->triangles);
    mesh->has_normals = mesh->made_normals = true;
    done = mesh_weld(mesh);
    mesh->joined = joined;
    return done;
}
