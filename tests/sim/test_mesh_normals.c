/* Normals of meshes that have none: the mean of the faces at a place that are
 * turned by the crease at most, by area; in a time that grows little faster
 * than the mesh. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "sim/mesh/mesh.h"
#include "sim/mesh/vector.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"

enum { CREASE = 30 };

/* Faces around the origin, of which each shows its corner there first. */
static void make(struct mesh *mesh, uint32_t faces)
{
    assert_true(mesh_init(mesh, 3 * faces, faces, 1));
    for (uint32_t i = 0; i < 3 * faces; i++)
        mesh->triangle[i / 3][i % 3] = i;
}

static double *corner_of(struct mesh *mesh, uint32_t face, int corner)
{
    return mesh->vertex[3 * face + (uint32_t)corner].position;
}

static double random_place(struct random *r)
{
    return random_between(r, -1000, 1000) / 1000.0;
}

/* Any way, each its own. */
static void set_any(struct mesh *mesh, uint32_t face, struct random *r)
{
    for (int k = 1; k < 3; k++)
        for (int axis = 0; axis < 3; axis++)
            corner_of(mesh, face, k)[axis] = random_place(r);
}

/* In one of 13 planes, most of them 30 degrees apart: equal ways, and pairs at
 * the crease itself. */
static void set_plane(struct mesh *mesh, uint32_t face, struct random *r)
{
    const double turn = random_between(r, 0, 12) * atan(1) / 1.5;
    for (int k = 1; k < 3; k++) {
        double *to = corner_of(mesh, face, k);
        const double along = random_place(r);
        to[0] = along * cos(turn);
        to[1] = along * sin(turn);
        to[2] = random_place(r);
    }
}

/* On a cone; every tenth has no area. */
static void set_cone(struct mesh *mesh, uint32_t face, struct random *r)
{
    for (int k = 1; k < 3; k++) {
        const double turn = (double)(face + (uint32_t)k - 1) / 50;
        double *to = corner_of(mesh, face, k);
        to[0] = cos(turn);
        to[1] = sin(turn);
        to[2] = -0.7;
    }
    if (random_between(r, 0, 9) == 0)
        memset(corner_of(mesh, face, 2), 0, 3 * sizeof(double));
}

typedef void set_face(struct mesh *mesh, uint32_t face, struct random *r);

/* Each face against each; how many differ from the means before. */
static uint32_t expect(const struct mesh *mesh, uint32_t faces,
                       double (*mean)[3])
{
    const double cosine = cos(CREASE * atan(1) / 45) - 1e-9;
    double(*facet)[3] = malloc(faces * sizeof *facet);
    uint32_t ways = 0;
    assert_non_null(facet);
    for (uint32_t i = 0; i < faces; i++)
        mesh_facet(mesh, mesh->triangle[i], facet[i]);
    for (uint32_t i = 0; i < faces; i++) {
        memset(mean[i], 0, sizeof mean[i]);
        for (uint32_t j = 0; j < faces; j++)
            if (vector_dot(facet[i], facet[j]) >=
                cosine * vector_length(facet[i]) * vector_length(facet[j]))
                for (int k = 0; k < 3; k++)
                    mean[i][k] += facet[j][k];
        vector_normalise(mean[i]);
        bool is_new = true;
        for (uint32_t j = 0; is_new && j < i; j++)
            is_new = memcmp(mean[i], mean[j], sizeof mean[i]) != 0;
        ways += is_new;
    }
    free(facet);
    return ways;
}

/* Vertices at the origin, which are as many as there are normals. */
static uint32_t at_origin(const struct mesh *mesh)
{
    uint32_t n = 0;
    for (uint32_t i = 0; i < mesh->vertices; i++)
        n += vector_length(mesh->vertex[i].position) == 0;
    return n;
}

static void check(set_face *set, uint32_t faces, struct random *r)
{
    struct mesh mesh;
    double(*mean)[3] = malloc(faces * sizeof *mean);
    assert_non_null(mean);
    make(&mesh, faces);
    for (uint32_t i = 0; i < faces; i++)
        set(&mesh, i, r);
    const uint32_t ways = expect(&mesh, faces, mean);
    assert_true(mesh_normals(&mesh, CREASE));
    for (uint32_t i = 0; i < faces; i++) {
        double off[3];
        vector_subtract(mesh.vertex[mesh.triangle[i][0]].normal, mean[i], off);
        if (!(vector_length(off) < 1e-9))
            fail_msg("face %u of %u: off by %g", i, faces, vector_length(off));
    }
    if (at_origin(&mesh) != ways)
        fail_msg("%u faces: %u vertices, not %u", faces, at_origin(&mesh),
                 ways);
    mesh_free(&mesh);
    free(mean);
}

TEST(means)
{
    static const uint32_t faces[] = {1, 2, 64, 65, 66, 130, 700, 4200};
    static set_face *const sets[] = {set_any, set_plane, set_cone};
    struct random r = {1};
    for (size_t i = 0; i < sizeof faces / sizeof *faces; i++)
        for (size_t k = 0; k < sizeof sets / sizeof *sets; k++)
            check(sets[k], faces[i], &r);
}

/* Seconds of CPU. */
static double time_of(set_face *set, uint32_t faces)
{
    struct mesh mesh;
    struct random r = {1};
    make(&mesh, faces);
    for (uint32_t i = 0; i < faces; i++)
        set(&mesh, i, &r);
    const clock_t start = clock();
    assert_true(mesh_normals(&mesh, CREASE));
    const double time = (double)(clock() - start) / CLOCKS_PER_SEC;
    mesh_free(&mesh);
    return time;
}

/* 4,000 faces have 1.6 * 10^7 pairs, 40,000 a hundred times as many; n sqrt n
 * grows by 32. Other programs disturb: the best of the larger runs counts. */
TEST(time)
{
    static set_face *const sets[] = {set_any, set_plane, set_cone};
    for (size_t k = 0; k < sizeof sets / sizeof *sets; k++) {
        double few = 0.01, many = INFINITY;
        for (int i = 0; i < 3; i++) {
            few = fmax(few, time_of(sets[k], 4000));
            many = fmin(many, time_of(sets[k], 40000));
        }
        if (many > 50 * few)
            fail_msg("set %zu: %.3f s for 4,000 faces, %.3f s for 40,000", k,
                     few, many);
    }
}
