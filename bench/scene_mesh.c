#include "scene_mesh.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "method.h"
#include "sim/mesh/model.h"

static double coordinate(const double *v, int axis, const double *low,
                         const double *high)
{
    return high[axis] > low[axis]
               ? (v[axis] - low[axis]) / (high[axis] - low[axis])
               : 0;
}

/* Places of texels: the mesh's own, or the picture seen from the front. */
static void set_uv(struct bench_mesh *m, const struct mesh *from,
                   uint16_t (*uv)[2])
{
    for (uint32_t i = 0; i < from->vertices; i++) {
        const struct mesh_vertex *v = &from->vertex[i];
        for (int k = 0; k < 2; k++) {
            double at = from->has_uv
                            ? v->uv[k] - floor(v->uv[k])
                            : coordinate(v->position, k, m->low, m->high);
            uv[i][k] = (uint16_t)(at * 65535);
        }
    }
    m->mesh.texture = (struct pel_quantization){{0, 0, 0}, 1, 16};
    m->mesh.uv = (void *)uv;
}

/* The largest side of the box becomes one unit, around (0, 0, 0). */
static void fit(struct mesh *from)
{
    double low[3], high[3], size = 0;
    mesh_box(from, low, high);
    for (int k = 0; k < 3; k++)
        size = fmax(size, high[k] - low[k]);
    for (uint32_t i = 0; i < from->vertices; i++)
        for (int k = 0; k < 3; k++)
            from->vertex[i].position[k] =
                (from->vertex[i].position[k] - (low[k] + high[k]) / 2) /
                (size > 0 ? size : 1);
}

static void quantise(struct bench_mesh *m, const struct mesh *from)
{
    int16_t(*positions)[3] =
        method_allocate((int)from->vertices, sizeof *positions);
    int8_t(*normals)[3] = method_allocate((int)from->vertices, sizeof *normals);
    uint8_t(*colors)[3] = method_allocate((int)from->vertices, sizeof *colors);
    m->mesh.position = quantize_positions(from, PEL_MESH_SHIFT_MAX);
    for (uint32_t i = 0; i < from->vertices; i++)
        for (int k = 0; k < 3; k++) {
            const struct mesh_vertex *v = &from->vertex[i];
            positions[i][k] =
                (int16_t)quantize(&m->mesh.position, k, v->position[k]);
            normals[i][k] = (int8_t)lround(v->normal[k] * 127);
            colors[i][k] = (uint8_t)(v->color >> (16 - 8 * k));
        }
    m->mesh.positions = (void *)positions;
    m->mesh.normals8 = (void *)normals;
    m->mesh.colors = (void *)colors;
}

static void convert(struct bench_mesh *m, struct mesh *from)
{
    uint32_t(*indices)[3] =
        method_allocate((int)from->triangles, sizeof *indices);
    fit(from);
    mesh_box(from, m->low, m->high);
    m->mesh = (struct pel_mesh){.vertices = from->vertices,
                                .triangles = from->triangles};
    for (uint32_t i = 0; i < from->triangles; i++)
        for (int k = 0; k < 3; k++)
            indices[i][k] = from->triangle[i][k];
    m->mesh.indices32 = (void *)indices;
    quantise(m, from);
    set_uv(m, from, method_allocate((int)from->vertices, 4));
}

bool bench_mesh_load(struct bench_mesh *m, const struct bench_mesh_file *from)
{
    const char *folder = getenv("PEL_MESHES");
    char path[4096];
    struct mesh mesh = {0};
    m->name = from->name;
    snprintf(path, sizeof path, "%s/%s", folder ? folder : ".", from->file);
    if (!folder || access(path, R_OK) != 0)
        snprintf(path, sizeof path, "%s", from->path ? from->path : "");
    if (access(path, R_OK) != 0) {
        printf("mesh %s: left out, it is not there; %s%s%s/%s brings it.\n",
               from->name, from->package ? from->package : "",
               from->package ? ", or " : "", "PEL_MESHES", from->file);
        return false;
    }
    if (!mesh_load(&mesh, path))
        return false;
    convert(m, &mesh);
    mesh_free(&mesh);
    return true;
}

enum { ACROSS_SHARE = 3 }; /* three times as many cells around as across */

static void place(struct mesh_vertex *v, double a, double b)
{
    const double r = 1 + .4 * cos(b) + .05 * sin(12 * a) * cos(4 * b);
    v->position[0] = r * cos(a);
    v->position[1] = .4 * sin(b);
    v->position[2] = r * sin(a);
    v->color =
        PEL_RGB(lround(128 + 100 * cos(a)), lround(128 + 100 * cos(b)), 160);
}

void bench_mesh_make(struct bench_mesh *m, uint32_t triangles)
{
    const uint32_t across = (uint32_t)lround(sqrt(triangles / 2. / 3));
    const uint32_t around = across * ACROSS_SHARE;
    const double turn = 8 * atan(1);
    struct mesh mesh = {0};
    if (!mesh_init(&mesh, across * around, 2 * across * around, 1))
        exit(2);
    for (uint32_t i = 0; i < across * around; i++) {
        const uint32_t a = i / across, b = i % across;
        const uint32_t next = (a + 1) % around * across, up = (b + 1) % across;
        const uint32_t two[2][3] = {{i, a * across + up, next + up},
                                    {i, next + up, next + b}};
        place(&mesh.vertex[i], a * turn / around, b * turn / across);
        for (int k = 0; k < 6; k++)
            mesh.triangle[2 * i + (uint32_t)k / 3][k % 3] = two[k / 3][k % 3];
    }
    mesh_normals(&mesh, MESH_CREASE);
    m->name = "ring";
    convert(m, &mesh);
    mesh_free(&mesh);
}

void bench_mesh_free(struct bench_mesh *m)
{
    free((void *)m->mesh.positions);
    free((void *)m->mesh.normals8);
    free((void *)m->mesh.uv);
    free((void *)m->mesh.colors);
    free((void *)m->mesh.indices32);
}
