#include "sim/mesh/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/mesh/quantize.h"
#include "sim/cli/message.h"
#include "sim/image/texture.h"

/* Memory for the arrays, which the mesh then views. */
struct arrays {
    int16_t (*positions)[3], (*normals16)[3];
    int8_t (*normals8)[3];
    uint16_t (*uv)[2];
    uint8_t (*colors)[3];
    uint16_t (*indices16)[3];
    uint32_t (*indices32)[3];
};

static void set_color(uint8_t to[3], pel_color color)
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
    set_color(a->colors[i], v->color);
}

static void set_triangle(const struct arrays *a, const uint32_t index[3],
                         uint32_t i)
{
    for (int k = 0; k < 3; k++)
        if (a->indices16)
            a->indices16[i][k] = (uint16_t)index[k];
        else
            a->indices32[i][k] = index[k];
}

static void view(struct pel_mesh *to, const struct arrays *a)
{
    to->positions = (const int16_t(*)[3])a->positions;
    to->normals16 = (const int16_t(*)[3])a->normals16;
    to->normals8 = (const int8_t(*)[3])a->normals8;
    to->uv = (const uint16_t(*)[2])a->uv;
    to->colors = (const uint8_t(*)[3])a->colors;
    to->indices16 = (const uint16_t(*)[3])a->indices16;
    to->indices32 = (const uint32_t(*)[3])a->indices32;
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
    view(to, a);
    return a->positions && (a->normals8 || a->normals16) && a->colors &&
           (a->uv || !mesh->has_uv) && (a->indices16 || a->indices32);
}

static bool make(struct model *model, const struct mesh *mesh, int shift_max,
                 int normal_bits)
{
    struct arrays arrays;
    struct pel_mesh *to = &model->mesh;
    memset(model, 0, sizeof(*model));
    if (!make_arrays(to, &arrays, mesh, normal_bits)) {
        model_free(model);
        return message_error("no memory for %u vertices and %u triangles",
                             mesh->vertices, mesh->triangles);
    }
    to->vertices = mesh->vertices;
    to->triangles = mesh->triangles;
    model->plain = !mesh->has_colors;
    mesh_box(mesh, model->low, model->high);
    to->position = quantize_positions(mesh, shift_max);
    to->texture = quantize_uv(mesh);
    for (uint32_t i = 0; i < mesh->vertices; i++)
        set_vertex(to, &arrays, &mesh->vertex[i], i);
    for (uint32_t i = 0; i < mesh->triangles; i++)
        set_triangle(&arrays, mesh->triangle[i], i);
    return true;
}

bool model_make(struct model *model, const struct mesh *mesh)
{
    return make(model, mesh, 64, 16);
}

bool model_make_asset(struct model *model, const struct mesh *mesh,
                      int normal_bits)
{
    return make(model, mesh, PEL_MESH_SHIFT_MAX, normal_bits);
}

void model_paint(struct model *model)
{
    const struct pel_mesh *m = &model->mesh;
    const struct pel_quantization *q = &m->texture;
    uint8_t(*to)[3] = (uint8_t(*)[3])(uintptr_t)m->colors;
    for (uint32_t i = 0; i < m->vertices; i++) {
        double at[2];
        for (int k = 0; k < 2; k++)
            at[k] = ldexp(pel_quantization_value(q, k, m->uv[i][k]), -q->shift);
        set_color(to[i], texture_at(&model->texture, at[0], at[1]));
    }
}

/* A texture inside the mesh file, or beside it; true when there is none. */
static bool load_own(struct picture *picture, const struct mesh *mesh,
                     const char *path)
{
    if (mesh->texture_bytes)
        return texture_load_bytes(picture, path, mesh->texture_bytes,
                                  mesh->texture_size);
    return !mesh->texture || texture_load(picture, mesh->texture);
}

bool model_add_texture(struct model *model, const struct mesh *mesh,
                       const struct model_source *source)
{
    struct picture *to = &model->texture;
    if (source->without_texture)
        return true;
    if (source->texture && !mesh->has_uv)
        return message_error_at(source->path, 0,
                                "the mesh has no texture coordinates, so a "
                                "texture cannot apply");
    if (source->texture && !texture_load(to, source->texture))
        return false;
    if (!source->texture && mesh->has_uv && !load_own(to, mesh, source->path))
        message_error_at(source->path, 0, "its texture is left out");
    model->texture_opaque = texture_opaque(to);
    return true;
}

bool model_load(struct model *model, const struct model_source *source)
{
    struct mesh mesh;
    memset(model, 0, sizeof(*model));
    if (!mesh_load(&mesh, source->path))
        return false;
    bool done = (!source->smooth_normals || mesh_normals(&mesh)) &&
                model_make(model, &mesh) &&
                model_add_texture(model, &mesh, source);
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
    picture_free(&model->texture);
    memset(model, 0, sizeof(*model));
}
