/* pel info: what a mesh file holds, and what of it cannot be drawn. */
#include <stdio.h>

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "sim/cli/message.h"
#include "sim/mesh/model.h"

static void print_part(const struct mesh *mesh, uint32_t i)
{
    static const char *const wraps[] = {"clamp", "repeat", "mirror"};
    const struct mesh_part *p = &mesh->part[i];
    const struct mesh_material *m = &p->material;
    message_print(stdout, "part %u: %u triangles, '%s', #%06x", i + 1,
                  p->triangles - (i ? p[-1].triangles : 0), m->name,
                  (unsigned)m->color & 0xFFFFFFu);
    if (pel_alpha(m->color) < 255)
        printf(" of opacity %.2f", pel_alpha(m->color) / 255.0);
    if (m->texture)
        printf(", texture %u (%s, %s)", m->texture, wraps[m->wrap_u],
               wraps[m->wrap_v]);
    if (m->texture && !p->has_uv)
        printf(" left out: the part has no uv");
    if (m->alpha == MESH_CUT_OUT)
        printf(", cut out below alpha %d", m->cutoff);
    if (m->glow_texture)
        printf(", shines by texture %u", m->glow_texture);
    if (m->is_colored)
        printf(", times the vertices' colours");
    if (m->is_unlit)
        printf(", unlit");
    printf("%s\n", m->alpha == MESH_BLENDED ? ", blended" : "");
}

/* A texture that no part with uv names is not read. */
static void print_texture(const struct mesh *mesh, const struct model *model,
                          uint32_t i)
{
    const struct mesh_texture *t = &mesh->texture[i];
    const struct picture *picture = NULL;
    bool shines = false;
    for (size_t k = 0; k < model->textures; k++) {
        const struct mesh_material *m = &model->texture[k].material;
        if (m->texture == i + 1 || (!m->texture && m->glow_texture == i + 1))
            picture = &model->texture[k].picture;
        if (m->texture && m->glow_texture == i + 1)
            shines = true;
    }
    printf("texture %u: ", i + 1);
    if (picture && picture->width > 0)
        printf("%d x %d, ", picture->width, picture->height);
    else
        printf("%s, ", picture ? "missing" : shines ? "shines" : "not used");
    message_print(stdout, "%s", t->path);
    puts(t->bytes ? " inside the file" : "");
}

/* Degenerate triangles: they show nothing. */
static uint32_t count_flat(const struct mesh *mesh)
{
    uint32_t n = 0;
    for (uint32_t i = 0; i < mesh->triangles; i++) {
        double normal[3];
        mesh_facet(mesh, mesh->triangle[i], normal);
        n += normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
    }
    return n;
}

static void print(const struct mesh *mesh, const struct model *model)
{
    printf("parts: %u, triangles: %u, vertices: %u, normals: %s\n", mesh->parts,
           mesh->triangles, mesh->vertices,
           mesh->made_normals ? "made" : "of the file");
    for (int k = 0; k < 3; k++)
        printf("%s%c %.6g to %.6g", k ? ", " : "box: ", 'x' + k, model->low[k],
               model->high[k]);
    printf("\n");
    for (uint32_t i = 0; i < mesh->parts; i++)
        print_part(mesh, i);
    for (uint32_t i = 0; i < mesh->textures; i++)
        print_texture(mesh, model, i);
    if (mesh->joined > 0)
        printf("joined: %u vertices that are the same as others\n",
               mesh->joined);
    if (count_flat(mesh) > 0)
        printf("not seen: %u triangles without area\n", count_flat(mesh));
}

int command_info(int argc, char **argv)
{
    static const struct option_row none[] = {{.help = NULL}};
    struct mesh mesh;
    struct model model;
    const struct command_line line = {
        .arguments = "MESH",
        .least = 1,
        .most = 1,
        .about = "Tells what a mesh file holds: parts, box, materials, "
                 "textures.\vMessages tell what of it pel leaves out.",
        .tables = {{none, NULL, NULL}}};
    const struct model_source source = {
        .path = *arguments_parse(&line, argc, argv)};
    if (!model_read(&mesh, &source))
        return STATUS_ERROR;
    const bool done = model_make(&model, &mesh, 0);
    if (done && model_add_textures(&model, &mesh, &source))
        print(&mesh, &model);
    if (done)
        model_free(&model);
    mesh_free(&mesh);
    return done ? STATUS_OK : STATUS_ERROR;
}
