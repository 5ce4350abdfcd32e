#include "sim/asset/import.h"

#include "core/scene/pipeline.h"
#include "sim/asset/text.h"

static void write_quantum(FILE *out, const struct pel_quantization *q)
{
    fprintf(out, "    {{%ld, %ld, %ld}, %ld, %ld},\n", (long)q->offset[0],
            (long)q->offset[1], (long)q->offset[2], (long)q->step,
            (long)q->shift);
}

/* Initialisers in the order of the struct, so that C++ takes them too. */
static void write_asset(struct import_text *text, const struct pel_mesh *m)
{
    FILE *out = text->output.stream;
    const char *name = text->options->name;
    const uint32_t n = m->vertices, t = m->triangles;
    const struct import_array arrays[7] = {
        {"int16_t", "positions", n, 3, m->positions},
        {"int8_t", "normals", n, 3, m->normals8},
        {"int16_t", "normals", n, 3, m->normals16},
        {"uint16_t", "uv", n, 2, m->uv},
        {"uint8_t", "colors", n, 3, m->colors},
        {"uint16_t", "indices", t, 3, m->indices16},
        {"uint32_t", "indices", t, 3, m->indices32},
    };
    for (int i = 0; i < 7; i++)
        import_array(text, &arrays[i]);
    import_struct_begin(text);
    fprintf(out, "    PEL_MESH_MAGIC,\n    PEL_MESH_VERSION,\n");
    fprintf(out, "    %u,\n    %u,\n", n, t);
    write_quantum(out, &m->position);
    write_quantum(out, &m->texture);
    for (int i = 0; i < 7; i++)
        if (arrays[i].data)
            fprintf(out, "    %s_%s,\n", name, arrays[i].what);
        else
            fprintf(out, "    NULL,\n");
    fprintf(out, "};\n");
}

/* A comment with the box of the mesh, for placing the camera, and the memory
 * that a scene with it takes. */
static void write_figures(FILE *out, const struct model *model)
{
    const struct pel_mesh counts = {.vertices = model->mesh.vertices,
                                    .triangles = model->mesh.triangles};
    const struct pel_scene scene = {.mesh = &counts};
    fprintf(out, "\n/* %u vertices, %u triangles, in this box of units:\n",
            counts.vertices, counts.triangles);
    for (int k = 0; k < 3; k++)
        fprintf(out, " *     %c %.6g to %.6g\n", 'x' + k, model->low[k],
                model->high[k]);
    fprintf(out,
            " * pel_scene_prepare takes %zu bytes of scratch memory at most, "
            "and 40 for\n * each light. */\n",
            pel_scene_scratch_size(&scene));
}

bool import_mesh(const struct import_options *options,
                 const struct model *model)
{
    struct import_text text;
    if (!import_text_open(&text, options, "mesh"))
        return false;
    write_figures(text.output.stream, model);
    write_asset(&text, &model->mesh);
    return import_text_commit(&text);
}
