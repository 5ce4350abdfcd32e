#include "sim/asset/import.h"

#include <math.h>

#include "core/scene/pipeline.h"
#include "sim/mesh/quantize.h"
#include "sim/asset/text.h"

struct import {
    struct import_text text;
    const struct import_options *options;
    const struct mesh *mesh;
    struct pel_quantization position, texture;
};

/* Element i of an array, n numbers of it. */
typedef void element_function(const struct import *import, uint32_t i,
                              long *value);

static void get_position(const struct import *import, uint32_t i, long *value)
{
    for (int k = 0; k < 3; k++)
        value[k] = import_quantised(&import->position, k,
                                    import->mesh->vertex[i].position[k]);
}

static void get_normal(const struct import *import, uint32_t i, long *value)
{
    double one = import->options->normal_bits == 8 ? 127 : 32767;
    for (int k = 0; k < 3; k++)
        value[k] = lround(import->mesh->vertex[i].normal[k] * one);
}

static void get_uv(const struct import *import, uint32_t i, long *value)
{
    for (int k = 0; k < 2; k++)
        value[k] = import_quantised(&import->texture, k,
                                    import->mesh->vertex[i].uv[k]);
}

static void get_color(const struct import *import, uint32_t i, long *value)
{
    pel_color color = import->mesh->vertex[i].color;
    value[0] = (long)pel_red(color);
    value[1] = (long)pel_green(color);
    value[2] = (long)pel_blue(color);
}

static void get_triangle(const struct import *import, uint32_t i, long *value)
{
    for (int k = 0; k < 3; k++)
        value[k] = (long)import->mesh->triangle[i][k];
}

static void write_array(struct import *import, const struct import_array *array,
                        element_function *get)
{
    import_array_begin(&import->text, import->options->name, array);
    for (uint32_t i = 0; i < array->count; i++) {
        long value[3];
        get(import, i, value);
        import_array_item(&import->text, value, array->axes);
    }
    import_array_end(&import->text);
}

static bool has_small_indices(const struct mesh *mesh)
{
    return mesh->vertices <= 65536;
}

static void write_arrays(struct import *import)
{
    const struct mesh *mesh = import->mesh;
    const bool bytes = import->options->normal_bits == 8;
    const bool small = has_small_indices(mesh);
    const uint32_t n = mesh->vertices;
    const struct import_array positions = {"int16_t", "positions", n, 3};
    const struct import_array normals = {bytes ? "int8_t" : "int16_t",
                                         "normals", n, 3};
    const struct import_array uv = {"uint16_t", "uv", n, 2};
    const struct import_array colors = {"uint8_t", "colors", n, 3};
    const struct import_array indices = {small ? "uint16_t" : "uint32_t",
                                         "indices", mesh->triangles, 3};
    write_array(import, &positions, get_position);
    write_array(import, &normals, get_normal);
    if (mesh->has_uv)
        write_array(import, &uv, get_uv);
    write_array(import, &colors, get_color);
    write_array(import, &indices, get_triangle);
}

static void write_quantum(FILE *out, const struct pel_quantization *q)
{
    fprintf(out, "    {{%ld, %ld, %ld}, %ld, %ld},\n", (long)q->offset[0],
            (long)q->offset[1], (long)q->offset[2], (long)q->step,
            (long)q->shift);
}

/* Initialisers in the order of the struct, so that C++ takes them too. */
static void write_struct(struct import *import)
{
    FILE *out = import->text.output.stream;
    const struct mesh *mesh = import->mesh;
    const char *name = import->options->name;
    const bool bytes = import->options->normal_bits == 8;
    import_struct_begin(&import->text);
    fprintf(out, "    PEL_MESH_MAGIC,\n    PEL_MESH_VERSION,\n");
    fprintf(out, "    %u,\n    %u,\n", mesh->vertices, mesh->triangles);
    write_quantum(out, &import->position);
    write_quantum(out, &import->texture);
    fprintf(out, "    %s_positions,\n", name);
    fprintf(out,
            bytes ? "    %s_normals,\n    NULL,\n"
                  : "    NULL,\n    %s_normals,\n",
            name);
    fprintf(out, mesh->has_uv ? "    %s_uv,\n" : "    NULL,\n", name);
    fprintf(out, "    %s_colors,\n", name);
    fprintf(out,
            has_small_indices(mesh) ? "    %s_indices,\n    NULL,\n"
                                    : "    NULL,\n    %s_indices,\n",
            name);
    fprintf(out, "};\n");
}

/* What a firmware's author asks first: where the camera may stand, and how much
 * memory a scene with this mesh takes. */
static void write_figures(const struct import *import)
{
    FILE *out = import->text.output.stream;
    const struct mesh *mesh = import->mesh;
    const struct pel_mesh counts = {.vertices = mesh->vertices,
                                    .triangles = mesh->triangles};
    const struct pel_scene scene = {.mesh = &counts};
    double low[3], high[3];
    fprintf(out, "\n/* %u vertices, %u triangles, in this box of units:\n",
            mesh->vertices, mesh->triangles);
    mesh_box(mesh, low, high);
    for (int k = 0; k < 3; k++)
        fprintf(out, " *     %c %.6g to %.6g\n", 'x' + k, low[k], high[k]);
    fprintf(out,
            " * pel_scene_prepare takes %zu bytes of scratch memory at most, "
            "and 40 for\n * each light. */\n",
            pel_scene_scratch_size(&scene));
}

bool import_mesh(const struct import_options *options, const struct mesh *mesh)
{
    struct import import = {.options = options, .mesh = mesh};
    import.position = import_quantum(mesh, PEL_MESH_SHIFT_MAX);
    import.texture = import_quantum_uv(mesh);
    if (!import_text_open(&import.text, options, "mesh"))
        return false;
    write_figures(&import);
    write_arrays(&import);
    write_struct(&import);
    return import_text_commit(&import.text);
}
