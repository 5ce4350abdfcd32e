#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/mesh/model.h"
#include "sim/cli/list.h"
#include "sim/cli/text_line.h"
#include "sim/image/texture.h"

/* Alpha as the material has it: the least that is drawn becomes 128. */
static uint32_t alpha_of(const struct mesh_material *m, pel_color color)
{
    const int alpha = (int)pel_alpha(color);
    if (m->alpha == MESH_CUT_OUT)
        return (uint32_t)pel_max(pel_min(alpha + 128 - m->cutoff, 255), 0);
    return m->alpha == MESH_OPAQUE ? 255 : (uint32_t)alpha;
}

static void apply_material(struct model_texture *t)
{
    const struct mesh_material *m = &t->material;
    const size_t n = (size_t)t->picture.width * (size_t)t->picture.height;
    for (size_t i = 0; i < n; i++) {
        pel_color *texel = &t->picture.pixels[i], color = 0;
        for (int k = 0; k < 32; k += 8)
            color |=
                pel_round_div255((*texel >> k & 255) * (m->tint >> k & 255))
                << k;
        *texel = (color & 0xFFFFFFu) | alpha_of(m, color) << 24;
    }
    t->opaque = texture_opaque(&t->picture);
}

/* The picture of a texture before any material is applied, which is read once.
 */
struct original {
    struct picture picture; /* empty, with a message, when it cannot be read */
    bool is_read;
};

static bool copy_original(struct picture *to, struct original *from,
                          const struct mesh_texture *texture, const char *path)
{
    const struct picture *p = &from->picture;
    if (!from->is_read &&
        !(texture->bytes
              ? texture_load_bytes(&from->picture, path, texture->bytes,
                                   texture->size)
              : texture_load(&from->picture, file_named(texture->path))))
        message_error_at(path, 0, "its texture %s is left out", texture->path);
    from->is_read = true;
    if (p->width == 0 || !picture_init(to, p->width, p->height, 0))
        return false;
    memcpy(to->pixels, p->pixels,
           (size_t)p->width * (size_t)p->height * sizeof *p->pixels);
    return true;
}

/* The number of a material's texture; 0 when memory is short. Of one that
 * cannot be read the picture is empty. */
static uint32_t texture_of(struct model *model, const struct mesh_texture *from,
                           struct original *original,
                           const struct mesh_material *material,
                           const char *path)
{
    struct model_texture new = {.material = *material};
    for (uint32_t i = 0; i < model->textures; i++) {
        const struct mesh_material *a = &model->texture[i].material;
        const struct mesh_material *b = material;
        if (a->texture == b->texture && a->tint == b->tint &&
            a->alpha == b->alpha && a->cutoff == b->cutoff &&
            a->wrap_u == b->wrap_u && a->wrap_v == b->wrap_v)
            return i + 1;
    }
    if (copy_original(&new.picture, original, from, path))
        apply_material(&new);
    if (list_add(&model->texture, &model->textures, &new, sizeof(new)))
        return (uint32_t)model->textures;
    picture_free(&new.picture);
    return 0;
}

bool model_set_picture(struct model *model, const struct picture *picture)
{
    const struct model_texture new = {
        .material = {.tint = PEL_RGB(255, 255, 255),
                     .alpha = MESH_BLENDED,
                     .wrap_u = PEL_WRAP_REPEAT,
                     .wrap_v = PEL_WRAP_REPEAT},
        .picture = *picture,
        .opaque = texture_opaque(picture)};
    if (!list_add(&model->texture, &model->textures, &new, sizeof(new)))
        return false;
    for (uint32_t i = 0; i < model->mesh.parts; i++)
        model->part[i].texture = (uint32_t)model->textures;
    return true;
}

/* The textures that the materials name; of each that is read the number. */
static bool add_own(struct model *model, const struct mesh *mesh,
                    const char *path)
{
    struct original *original = calloc(mesh->textures + 1, sizeof *original);
    bool done = original || message_error("out of memory");
    for (uint32_t i = 0; done && i < mesh->parts; i++) {
        const struct mesh_material *m = &mesh->part[i].material;
        const uint32_t k = m->texture - 1;
        if (!m->texture || !mesh->part[i].has_uv)
            continue;
        const uint32_t number =
            texture_of(model, &mesh->texture[k], &original[k], m, path);
        done = number > 0;
        if (done && model->texture[number - 1].picture.width > 0)
            model->part[i].texture = number;
    }
    for (size_t i = 0; original && i < mesh->textures; i++)
        picture_free(&original[i].picture);
    free(original);
    return done;
}

bool model_add_textures(struct model *model, const struct mesh *mesh,
                        const struct model_source *source)
{
    struct picture picture;
    if (source->without_texture)
        return true;
    if (!source->texture)
        return add_own(model, mesh, source->path);
    if (!mesh->has_uv)
        return message_error_at(source->path, 0,
                                "the mesh has no texture coordinates, so a "
                                "texture cannot apply");
    if (!texture_load(&picture, source->texture))
        return false;
    if (!model_set_picture(model, &picture)) {
        picture_free(&picture);
        return false;
    }
    for (uint32_t i = 0; i < mesh->parts; i++)
        if (!mesh->part[i].has_uv)
            model->part[i].texture = 0;
    return true;
}

void model_paint(struct model *model)
{
    const struct pel_mesh *m = &model->mesh;
    const struct pel_quantization *q = &m->texture;
    const struct pel_mesh_part *part = m->part;
    uint8_t(*to)[3] = (uint8_t(*)[3])(uintptr_t)m->colors;
    for (uint32_t i = 0; i < m->vertices; i++) {
        double at[2];
        while (i == part->vertices)
            part++;
        for (int k = 0; k < 2 && part->texture; k++)
            at[k] = ldexp(pel_quantization_value(q, k, m->uv[i][k]), -q->shift);
        if (part->texture)
            model_set_color(
                to[i], texture_at(&model->texture[part->texture - 1].picture,
                                  at[0], at[1]));
    }
}
