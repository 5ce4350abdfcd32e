#include "sim/asset/import.h"

#include "core/format/argb8888.h"
#include "core/scene/pipeline.h"
#include "core/scene/perspective.h"
#include "sim/asset/measure.h"
#include "sim/asset/report.h"
#include "sim/asset/text.h"
#include "sim/cli/message.h"

static void write_quantum(FILE *out, const struct pel_quantization *q)
{
    fprintf(out, "    {{%ld, %ld, %ld}, %ld, %ld},\n", (long)q->offset[0],
            (long)q->offset[1], (long)q->offset[2], (long)q->step,
            (long)q->shift);
}

/* A part that is opaque and has the first texture or none says no more than a
 * mesh without parts. */
static uint32_t parts_of(const struct pel_mesh *m)
{
    return m->parts > 1 || pel_alpha(m->part->color) < 255 ? m->parts : 0;
}

static void write_parts(FILE *out, const char *name, const struct pel_mesh *m)
{
    fprintf(out, "\nstatic const struct pel_mesh_part %s_parts[%u] = {\n", name,
            m->parts);
    for (uint32_t i = 0; i < m->parts; i++)
        fprintf(out, "    {%u, %u, 0x%08lX, %u},\n", m->part[i].vertices,
                m->part[i].triangles, (unsigned long)m->part[i].color,
                m->part[i].texture);
    fprintf(out, "};\n");
}

/* The image assets, and the list that names them. */
static bool write_textures(struct import_text *text, const struct model *model,
                           const struct pel_format *format)
{
    FILE *out = text->output.stream;
    const char *name = text->options->name;
    for (unsigned i = 0; i < model->textures; i++) {
        struct model_texture *t = &model->texture[i];
        if (t->picture.width == 0)
            return message_error_at(text->options->source, 0,
                                    "lacks a texture that --format writes: "
                                    "expected it beside the mesh");
        if (t->material.is_colored)
            message_error_at(text->options->source, 0,
                             "the colours of its vertices multiply texture "
                             "%u, which is written as it is",
                             i + 1);
        model_add_glow(t);
        if (!import_texture(text, i + 1, &t->picture,
                            t->opaque ? format : &pel_argb8888))
            return false;
    }
    fprintf(out, "\nstatic const struct pel_mesh_image %s_images[%zu] = {\n",
            name, model->textures);
    for (unsigned i = 0; i < model->textures; i++) {
        const struct mesh_material *m = &model->texture[i].material;
        fprintf(out, "    {&%s_texture_%u, %u, %u, %s},\n", name, i + 1,
                m->wrap_u, m->wrap_v,
                m->alpha == MESH_CUT_OUT ? "true" : "false");
    }
    fprintf(out, "};\n");
    return true;
}

/* The name of an array, or NULL. */
static void write_name(FILE *out, const char *name, const char *what)
{
    if (what)
        fprintf(out, "    %s_%s,\n", name, what);
    else
        fprintf(out, "    NULL,\n");
}

/* The shading of all parts, or of each by a shading that asks for the part. */
static void write_shading(FILE *out, const char *name, const struct measure *m)
{
    bool one = true, in_world = false;
    for (size_t i = 0; i < m->parts; i++) {
        one = one && m->shading[i] == m->shading[0];
        in_world = in_world || measure_in_world(m->shading[i]);
    }
    if (one) {
        fprintf(out, "const struct pel_shading *const %s_shading =\n    &%s;\n",
                name, measure_shading_name(m, m->shading[0]));
        return;
    }
    fprintf(out,
            "static const struct pel_shading *const %s_shadings[%zu] = {\n",
            name, m->parts);
    for (size_t i = 0; i < m->parts; i++)
        fprintf(out, "    &%s,\n", measure_shading_name(m, m->shading[i]));
    fprintf(out,
            "};\n\n"
            "static pel_color %s_vertex(const struct pel_frame *frame,\n"
            "    uint32_t vertex, pel_color surface)\n"
            "{\n"
            "    const struct pel_shading *s = %s_shadings[frame->part];\n"
            "    return s->vertex ? s->vertex(frame, vertex, surface) : "
            "surface;\n"
            "}\n\n",
            name, name);
    fprintf(out,
            "static const struct pel_paint *%s_paint(struct pel_frame *frame,\n"
            "    const struct pel_color_paint *surface, const pel_color "
            "color[3])\n"
            "{\n"
            "    return %s_shadings[frame->part]->paint(frame, surface, "
            "color);\n"
            "}\n\n"
            "static const struct pel_shading %s_of_part = {\n"
            "    %s, %s_vertex, %s_paint,\n"
            "    %s};\n"
            "const struct pel_shading *const %s_shading = &%s_of_part;\n",
            name, name, name, m->lit ? "pel_frame_start_light" : "NULL", name,
            name, in_world ? "PEL_PERSPECTIVE_SCRATCH_SIZE" : "0", name, name);
}

static void write_mappings(FILE *out, const char *name, const struct measure *m)
{
    fprintf(out, "const struct pel_mapping *const %s_mapping[%zu] = {\n", name,
            m->textures);
    for (size_t i = 0; i < m->textures; i++)
        fprintf(out, "    &%s,\n", measure_mapping_name(m->mapping[i]));
    fprintf(out, "};\nconst uint8_t %s_span[%zu] = {", name, m->textures);
    for (size_t i = 0; i < m->textures; i++)
        fprintf(out, "%s%d", i ? ", " : "",
                measure_mapping_span(m->mapping[i]));
    fprintf(out, "};\n");
}

/* What measuring found: with it firmware links the methods that it names. */
static void write_measured(struct import_text *text)
{
    FILE *out = text->output.stream;
    const struct measure *m = text->options->measure;
    if (!m)
        return;
    fprintf(out,
            "\n/* The cheapest that stayed within %g steps of 255 of what is "
            "exact at every\n * pixel, in %d views of %d x %d px. Of other "
            "views it says nothing. */\n",
            m->tolerance, m->count, m->width, m->height);
    write_shading(out, text->options->name, m);
    if (m->textures)
        write_mappings(out, text->options->name, m);
}

/* Initialisers in the order of the struct, so that C++ takes them too. */
static void write_asset(struct import_text *text, const struct pel_mesh *m,
                        size_t images)
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
    if (parts_of(m))
        write_parts(out, name, m);
    import_struct_begin(text);
    fprintf(out, "    PEL_MESH_MAGIC,\n    PEL_MESH_VERSION,\n");
    fprintf(out, "    %u,\n    %u,\n", n, t);
    write_quantum(out, &m->position);
    write_quantum(out, &m->texture);
    for (int i = 0; i < 7; i++)
        write_name(out, name, arrays[i].data ? arrays[i].what : NULL);
    write_name(out, name, parts_of(m) ? "parts" : NULL);
    write_name(out, name, images ? "images" : NULL);
    fprintf(out, "    %u,\n    %zu,\n};\n", parts_of(m), images);
    write_measured(text);
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
            "40 more for\n * each light; shadings in perspective "
            "PEL_PERSPECTIVE_SCRATCH_SIZE more. */\n",
            pel_scene_scratch_size(&scene));
}

bool import_mesh(const struct import_options *options,
                 const struct model *model, const struct pel_format *format)
{
    struct import_text text;
    const size_t images = format ? model->textures : 0;
    if (format && images == 0)
        return message_error_at(options->source, 0,
                                "has no texture: expected no --format");
    if (!import_text_open(&text, options, "mesh"))
        return false;
    text.shading = options->measure != NULL;
    text.mappings = text.shading ? (unsigned)options->measure->textures : 0;
    if (images && !write_textures(&text, model, format)) {
        output_abandon(&text.output);
        return false;
    }
    write_figures(text.output.stream, model);
    write_asset(&text, &model->mesh, images);
    const bool done = import_text_commit(&text);
    if (done)
        report_mesh(options, model, format);
    if (done)
        report_measure(options);
    return done;
}
