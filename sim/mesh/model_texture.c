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

/* The texel of another texture that lies on the same place. */
static pel_color beside(const struct picture *other, const struct picture *p,
                        int x, int y)
{
    return picture_row(
        other,
        (2 * y + 1) * other->height /
            (2 * p->height))[(2 * x + 1) * other->width / (2 * p->width)];
}

static const double none[4], ones[] = {1, 1, 1, 1};
static const pel_color white = PEL_RGB(255, 255, 255);

/* Light times light, and what shines by itself. */
static pel_color linear_texel(const double factor[4], pel_color texel,
                              const double shine[3], pel_color glow)
{
    static double linear[256];
    unsigned byte[3];
    for (unsigned i = 0; i < 256 && linear[255] == 0; i++)
        linear[i] = mesh_linear(i);
    for (int k = 0; k < 3; k++)
        byte[k] = mesh_byte(linear[texel >> (16 - 8 * k) & 255] * factor[k] +
                            linear[glow >> (16 - 8 * k) & 255] * shine[k]);
    return PEL_RGBA(byte[0], byte[1], byte[2],
                    (pel_color)(pel_alpha(texel) * factor[3] + 0.5));
}

static pel_color tinted(const struct mesh_material *m, pel_color texel)
{
    pel_color color = 0;
    for (int k = 0; k < 32; k += 8)
        color |= pel_round_div255((texel >> k & 255) * (m->tint >> k & 255))
                 << k;
    return color;
}

static void apply_material(struct model_texture *t, const struct picture *glow)
{
    const struct mesh_material *m = &t->material;
    const struct picture *p = &t->picture;
    const bool apart = t->glow.pixels;
    for (int y = 0; y < p->height; y++)
        for (int x = 0; x < p->width; x++) {
            pel_color *texel = &picture_row(p, y)[x];
            const pel_color under = m->texture ? *texel : white;
            const pel_color shine =
                glow->pixels ? beside(glow, p, x, y) : white;
            const pel_color color =
                m->is_linear ? linear_texel(m->factor, under,
                                            apart ? none : m->glow, shine)
                             : tinted(m, under);
            *texel = (color & 0xFFFFFFu) | alpha_of(m, color) << 24;
            if (apart)
                picture_row(&t->glow, y)[x] =
                    linear_texel(none, white, m->glow, shine) | ~0xFFFFFFu;
        }
    t->opaque = texture_opaque(p);
}

void model_add_glow(struct model_texture *t)
{
    for (int y = 0; y < t->glow.height; y++)
        for (int x = 0; x < t->glow.width; x++) {
            pel_color *texel = &picture_row(&t->picture, y)[x];
            *texel =
                linear_texel(ones, *texel, ones, picture_row(&t->glow, y)[x]);
        }
}

/* The picture of a texture before any material is applied, which is read once.
 */
struct original {
    struct picture picture; /* empty, with a message, when it cannot be read */
    bool is_read;
};

/* The pictures of all textures of a mesh. */
struct originals {
    const struct mesh *mesh;
    const char *path;
    struct original *original;
};

/* That of a number, which is there while the others are. Empty, with a message
 * the first time, when it cannot be read. */
static const struct picture *original_of(struct originals *all, uint32_t number)
{
    const struct mesh_texture *from = &all->mesh->texture[number - 1];
    struct original *o = &all->original[number - 1];
    if (!o->is_read &&
        !(from->bytes ? texture_load_bytes(&o->picture, all->path, from->bytes,
                                           from->size)
                      : texture_load(&o->picture, file_named(from->path))))
        message_error_at(all->path, 0, "its texture %s is left out",
                         from->path);
    o->is_read = true;
    return &o->picture;
}

static bool copy(struct picture *to, const struct picture *from)
{
    if (from->width == 0 || !picture_init(to, from->width, from->height, 0))
        return false;
    memcpy(to->pixels, from->pixels,
           (size_t)from->width * (size_t)from->height * sizeof *from->pixels);
    return true;
}

static bool is_same(const struct mesh_material *a,
                    const struct mesh_material *b)
{
    return a->texture == b->texture && a->tint == b->tint &&
           a->alpha == b->alpha && a->cutoff == b->cutoff &&
           a->wrap_u == b->wrap_u && a->wrap_v == b->wrap_v &&
           a->is_colored == b->is_colored &&
           a->glow_texture == b->glow_texture &&
           memcmp(a->factor, b->factor, sizeof(a->factor)) == 0 &&
           memcmp(a->glow, b->glow, sizeof(a->glow)) == 0;
}

/* The number of a material's texture; 0 when memory is short. Of one that
 * cannot be read the picture is empty. Without a texture it is that of what
 * shines. */
static uint32_t texture_of(struct model *model, struct originals *originals,
                           const struct mesh_material *material)
{
    static const struct picture no_picture;
    struct model_texture new = {.material = *material};
    const uint32_t glow = material->glow_texture;
    for (uint32_t i = 0; i < model->textures; i++)
        if (is_same(&model->texture[i].material, material))
            return i + 1;
    const struct picture *from =
        original_of(originals, material->texture ? material->texture : glow);
    const double *shine = material->glow;
    if (copy(&new.picture, from) &&
        (!material->is_colored || shine[0] + shine[1] + shine[2] == 0 ||
         copy(&new.glow, from)))
        apply_material(&new, glow ? original_of(originals, glow) : &no_picture);
    if (list_add(&model->texture, &model->textures, &new, sizeof(new)))
        return (uint32_t)model->textures;
    picture_free(&new.picture);
    picture_free(&new.glow);
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
    struct originals originals = {mesh, path, original};
    bool done = original || message_error("out of memory");
    for (uint32_t i = 0; done && i < mesh->parts; i++) {
        const struct mesh_material *m = &mesh->part[i].material;
        if (!(m->texture || m->glow_texture) || !mesh->part[i].has_uv)
            continue;
        const uint32_t number = texture_of(model, &originals, m);
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

/* What the vertex has of its own stays in it where it multiplies the texels. */
static void paint_vertex(uint8_t to[3], const struct model_texture *t,
                         const double at[2])
{
    const pel_color color = texture_at(&t->picture, at[0], at[1]);
    const double own[] = {mesh_linear(to[0]), mesh_linear(to[1]),
                          mesh_linear(to[2]), 1};
    const pel_color glow =
        t->glow.pixels ? texture_at(&t->glow, at[0], at[1]) : 0;
    model_set_color(to, t->material.is_colored
                            ? linear_texel(own, color, ones, glow)
                            : color);
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
            paint_vertex(to[i], &model->texture[part->texture - 1], at);
    }
}
