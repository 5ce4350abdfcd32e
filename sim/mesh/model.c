#include "sim/mesh/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"

/* One less than what the numbers hold, for the rounding of the offset. */
#define NUMBERS_EACH_SIDE 32766
#define STEP_MAX 16384
#define OFFSET_MAX 1073741824.0

struct extent {
    double origin[3]; /* the middle, or the least */
    double half;      /* of the longest axis */
};

/* The largest shift for which step and offsets are legal: of the mesh's own
 * size it leaves at least 13 bits in the step, unless the mesh is far from the
 * origin. */
static bool fits(const struct extent *e, int shift, double *step)
{
    *step = fmax(ceil(ldexp(e->half / NUMBERS_EACH_SIDE, shift)), 1);
    bool legal = *step <= STEP_MAX;
    for (int k = 0; k < 3; k++)
        legal = legal && fabs(ldexp(e->origin[k], shift)) <= OFFSET_MAX;
    return legal;
}

static struct pel_quantization quantum_of(const struct extent *e, int shift)
{
    struct pel_quantization quantum;
    double step = 1;
    while (shift > -64 && !fits(e, shift, &step))
        shift--;
    for (int k = 0; k < 3; k++)
        quantum.offset[k] = (int32_t)lround(ldexp(e->origin[k], shift));
    quantum.step = (int32_t)step;
    quantum.shift = shift;
    return quantum;
}

struct pel_quantization quantize_positions(const struct mesh *mesh,
                                           int shift_max)
{
    struct extent e = {{0}, 0};
    double low[3], high[3];
    mesh_box(mesh, low, high);
    for (int k = 0; k < 3; k++) {
        e.half = fmax(e.half, (high[k] - low[k]) / 2);
        e.origin[k] = (low[k] + high[k]) / 2;
    }
    return quantum_of(&e, shift_max);
}

/* For its uv: unsigned numbers, from the least coordinates on. */
static struct pel_quantization quantize_uv(const struct mesh *mesh)
{
    struct extent e = {{0}, 0};
    for (int k = 0; k < 2; k++) {
        double high = -INFINITY;
        e.origin[k] = INFINITY;
        for (uint32_t i = 0; i < mesh->vertices; i++) {
            e.origin[k] = fmin(e.origin[k], mesh->vertex[i].uv[k]);
            high = fmax(high, mesh->vertex[i].uv[k]);
        }
        e.half = fmax(e.half, (high - e.origin[k]) / 2);
    }
    return quantum_of(&e, PEL_MESH_SHIFT_MAX);
}

long quantize(const struct pel_quantization *quantum, int axis, double value)
{
    double numerator = ldexp(value, quantum->shift) - quantum->offset[axis];
    return lround(numerator / quantum->step);
}

/* Memory for the arrays, which the mesh then views. */
struct arrays {
    int16_t (*positions)[3], (*normals16)[3];
    int8_t (*normals8)[3];
    uint16_t (*uv)[2];
    uint8_t (*colors)[3];
    uint16_t (*indices16)[3];
    uint32_t (*indices32)[3];
};

void model_set_color(uint8_t to[3], pel_color color)
{
    to[0] = (uint8_t)pel_red(color);
    to[1] = (uint8_t)pel_green(color);
    to[2] = (uint8_t)pel_blue(color);
}

static void set_vertex(const struct pel_mesh *to, const struct arrays *a,
                       const struct mesh_vertex *v, uint32_t i)
{
    for (int k = 0; k < 3; k++) {
        a->positions[i][k] =
            (int16_t)quantize(&to->position, k, v->position[k]);
        if (a->normals8)
            a->normals8[i][k] = (int8_t)lround(v->normal[k] * 127);
        else
            a->normals16[i][k] = (int16_t)lround(v->normal[k] * 32767);
    }
    for (int k = 0; k < 2 && a->uv; k++)
        a->uv[i][k] = (uint16_t)quantize(&to->texture, k, v->uv[k]);
    model_set_color(a->colors[i], v->color);
}

static bool make_arrays(struct pel_mesh *to, struct arrays *a,
                        const struct mesh *mesh, int normal_bits)
{
    const size_t n = mesh->vertices, m = mesh->triangles;
    memset(a, 0, sizeof(*a));
    a->positions = malloc(n * sizeof(*a->positions));
    if (normal_bits == 8)
        a->normals8 = malloc(n * sizeof(*a->normals8));
    else
        a->normals16 = malloc(n * sizeof(*a->normals16));
    a->colors = malloc(n * sizeof(*a->colors));
    if (mesh->has_uv)
        a->uv = malloc(n * sizeof(*a->uv));
    if (n <= 65536)
        a->indices16 = malloc(m * sizeof(*a->indices16));
    else
        a->indices32 = malloc(m * sizeof(*a->indices32));
    to->positions = (const int16_t(*)[3])a->positions;
    to->normals16 = (const int16_t(*)[3])a->normals16;
    to->normals8 = (const int8_t(*)[3])a->normals8;
    to->uv = (const uint16_t(*)[2])a->uv;
    to->colors = (const uint8_t(*)[3])a->colors;
    to->indices16 = (const uint16_t(*)[3])a->indices16;
    to->indices32 = (const uint32_t(*)[3])a->indices32;
    return a->positions && (a->normals8 || a->normals16) && a->colors &&
           (a->uv || !mesh->has_uv) && (a->indices16 || a->indices32);
}

/* Do all materials show their colours without light? */
static bool is_unlit(const struct mesh *mesh)
{
    for (uint32_t i = 0; i < mesh->parts; i++)
        if (!mesh->part[i].material.is_unlit)
            return false;
    return true;
}

bool model_make(struct model *model, const struct mesh *mesh, int asset_bits)
{
    struct arrays arrays;
    struct pel_mesh *to = &model->mesh;
    memset(model, 0, sizeof(*model));
    to->part = model->part = malloc(mesh->parts * sizeof(*model->part));
    if (!make_arrays(to, &arrays, mesh, asset_bits) || !to->part) {
        model_free(model);
        return message_error("no memory for %u vertices and %u triangles",
                             mesh->vertices, mesh->triangles);
    }
    to->vertices = mesh->vertices;
    to->triangles = mesh->triangles;
    model->plain = !mesh->has_colors && !is_unlit(mesh);
    to->parts = mesh->parts;
    for (uint32_t i = 0; i < mesh->parts; i++)
        model->part[i] = (struct pel_mesh_part){
            mesh->part[i].vertices, mesh->part[i].triangles,
            mesh->part[i].material.color, 0};
    mesh_box(mesh, model->low, model->high);
    to->position =
        quantize_positions(mesh, asset_bits ? PEL_MESH_SHIFT_MAX : 64);
    to->texture = quantize_uv(mesh);
    for (uint32_t i = 0; i < mesh->vertices; i++)
        set_vertex(to, &arrays, &mesh->vertex[i], i);
    for (uint32_t i = 0; i < 3 * mesh->triangles; i++)
        if (arrays.indices16)
            arrays.indices16[i / 3][i % 3] =
                (uint16_t)mesh->triangle[i / 3][i % 3];
        else
            arrays.indices32[i / 3][i % 3] = mesh->triangle[i / 3][i % 3];
    return true;
}

double model_middle(const struct model *model, double middle[3])
{
    double radius = 0;
    for (int k = 0; k < 3; k++) {
        const double half = (model->high[k] - model->low[k]) / 2;
        middle[k] = model->low[k] + half;
        radius += half * half;
    }
    return sqrt(radius);
}

bool model_read(struct mesh *mesh, const struct model_source *source)
{
    if (!mesh_load(mesh, source->path))
        return false;
    if ((!source->smooth_normals && !source->has_crease) ||
        mesh_normals(mesh, source->has_crease ? source->crease : MESH_CREASE))
        return true;
    mesh_free(mesh);
    return false;
}

bool model_load(struct model *model, const struct model_source *source)
{
    struct mesh mesh;
    memset(model, 0, sizeof(*model));
    if (!model_read(&mesh, source))
        return false;
    const bool done =
        model_make(model, &mesh, 0) && model_add_textures(model, &mesh, source);
    if (!done)
        model_free(model);
    mesh_free(&mesh);
    return done;
}

void model_free(struct model *model)
{
    const struct pel_mesh *m = &model->mesh;
    free((void *)m->positions);
    free((void *)m->normals16);
    free((void *)m->normals8);
    free((void *)m->uv);
    free((void *)m->colors);
    free((void *)m->indices16);
    free((void *)m->indices32);
    free(model->part);
    for (size_t i = 0; i < model->textures; i++) {
        picture_free(&model->texture[i].picture);
        picture_free(&model->texture[i].glow);
    }
    free(model->texture);
    memset(model, 0, sizeof(*model));
}
