/* Materials and textures (chapters 3.8, 3.9), KHR_texture_transform,
 * KHR_materials_unlit, KHR_materials_emissive_strength and
 * KHR_materials_pbrSpecularGlossiness. */
#include "sim/mesh/gltf.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/list.h"
#include "sim/cli/message.h"

/* A file, or bytes that are copied; called by the image's number or its URI. */
static bool make_texture(struct gltf *g, json_int_t index,
                         struct mesh_texture *to)
{
    const json_t *image = gltf_at(g, "images", index);
    const json_int_t view = gltf_index(g, image, "bufferView");
    const char *uri = json_string_value(json_object_get(image, "uri"));
    struct gltf_bytes bytes = {NULL, 0};
    if (!g->good)
        return false;
    if (view >= 0)
        bytes = gltf_whole_view(g, view);
    else if (!uri || !gltf_uri(g->path, uri, &bytes, &to->path))
        return gltf_refuse(
            g, "images[%lld] has no data: expected a uri or a bufferView",
            (long long)index);
    if (to->path)
        return true;
    to->size = bytes.size;
    to->bytes = malloc(bytes.size + 1);
    if (!bytes.at || !to->bytes || asprintf(&to->path, "*%d", (int)index) < 0)
        return gltf_refuse(
            g, "images[%lld] has no data: expected a uri or a bufferView",
            (long long)index);
    memcpy(to->bytes, bytes.at, bytes.size);
    return true;
}

static bool add_texture(struct gltf *g, struct mesh *mesh, json_int_t image,
                        uint32_t *number)
{
    struct mesh_texture new = {NULL, NULL, 0};
    if (!make_texture(g, image, &new))
        return false;
    for (*number = 1; *number <= mesh->textures; ++*number)
        if (strcmp(mesh->texture[*number - 1].path, new.path) == 0) {
            free(new.path);
            free(new.bytes);
            return true;
        }
    return list_add(&mesh->texture, &mesh->textures, &new, sizeof(new));
}

static enum pel_wrap wrap_of(json_int_t mode)
{
    return mode == 33071   ? PEL_WRAP_CLAMP
           : mode == 33648 ? PEL_WRAP_MIRROR
                           : PEL_WRAP_REPEAT;
}

/* u and v by T R S: a turn counter-clockwise as it is seen, with v downward. */
static void read_place(struct gltf *g, const json_t *info,
                       struct gltf_place *to)
{
    const json_t *extension =
        gltf_member(g, info, "extensions.KHR_texture_transform");
    double offset[2] = {0, 0}, scale[2] = {1, 1};
    const double turn = gltf_number(g, extension, "rotation", 0);
    gltf_numbers(g, extension, "offset", offset, 2);
    gltf_numbers(g, extension, "scale", scale, 2);
    to->set = gltf_index(g, extension, "texCoord");
    if (to->set < 0)
        to->set = gltf_index(g, info, "texCoord");
    if (to->set < 0)
        to->set = 0;
    const double c = turn == 0 ? 1 : cos(turn), s = turn == 0 ? 0 : sin(turn);
    const double uv[2][3] = {{c * scale[0], s * scale[1], offset[0]},
                             {-s * scale[0], c * scale[1], offset[1]}};
    memcpy(to->uv, uv, sizeof(uv));
}

struct texture {
    uint32_t number; /* 0: none */
    enum pel_wrap wrap[2];
    struct gltf_place place;
};

static bool read_texture(struct gltf *g, struct mesh *mesh, const json_t *info,
                         struct texture *to)
{
    memset(to, 0, sizeof(*to));
    if (!info)
        return true;
    const json_t *texture =
        gltf_at(g, "textures", gltf_index(g, info, "index"));
    const json_int_t sampler = gltf_index(g, texture, "sampler");
    const json_int_t image = gltf_index(g, texture, "source");
    const json_t *wraps = sampler >= 0 ? gltf_at(g, "samplers", sampler) : NULL;
    to->wrap[0] = wrap_of(gltf_index(g, wraps, "wrapS"));
    to->wrap[1] = wrap_of(gltf_index(g, wraps, "wrapT"));
    read_place(g, info, &to->place);
    if (g->good && image < 0) {
        message_error_at(g->path, 0, "a texture without an image is left out");
        return true;
    }
    return g->good && add_texture(g, mesh, image, &to->number);
}

/* A float may be a little more than the number that was meant. */
static void read_alpha(struct gltf *g, const json_t *json,
                       struct mesh_material *to)
{
    const char *mode = json_string_value(json_object_get(json, "alphaMode"));
    const double cutoff = gltf_number(g, json, "alphaCutoff", 0.5);
    to->alpha = !mode                        ? MESH_OPAQUE
                : strcmp(mode, "BLEND") == 0 ? MESH_BLENDED
                : strcmp(mode, "MASK") == 0  ? MESH_CUT_OUT
                                             : MESH_OPAQUE;
    to->cutoff = (uint16_t)fmin(ceil(fmax(cutoff, 0) * 255 - 1e-4), 256);
}

/* What shines by itself is added to what the light shows: here both are one
 * colour. */
static bool read_glow(struct gltf *g, struct mesh *mesh, const json_t *json,
                      const struct texture *base, struct gltf_material *to)
{
    struct mesh_material *m = &to->material;
    struct texture glow;
    const double strength = gltf_number(
        g, gltf_member(g, json, "extensions.KHR_materials_emissive_strength"),
        "emissiveStrength", 1);
    gltf_numbers(g, json, "emissiveFactor", m->glow, 3);
    for (int k = 0; k < 3; k++)
        m->glow[k] *= strength;
    if ((m->glow[0] == 0 && m->glow[1] == 0 && m->glow[2] == 0) ||
        !gltf_member(g, json, "emissiveTexture"))
        return g->good;
    if (!read_texture(g, mesh, gltf_member(g, json, "emissiveTexture"), &glow))
        return false;
    if (base->number &&
        memcmp(&base->place, &glow.place, sizeof(glow.place)) != 0) {
        message_error_at(g->path, 0,
                         "the emissive texture of '%s' does not lie as its "
                         "other one and is left out",
                         m->name);
        memset(m->glow, 0, sizeof(m->glow));
        return true;
    }
    m->glow_texture = glow.number;
    if (!base->number) {
        to->place = glow.place;
        m->wrap_u = glow.wrap[0];
        m->wrap_v = glow.wrap[1];
    }
    return true;
}

bool gltf_material(struct gltf *g, struct mesh *mesh, json_int_t index,
                   struct gltf_material *to)
{
    const json_t *json = index < 0 ? NULL : gltf_at(g, "materials", index);
    const json_t *old =
        gltf_member(g, json, "extensions.KHR_materials_pbrSpecularGlossiness");
    const json_t *base =
        old ? old : gltf_member(g, json, "pbrMetallicRoughness");
    const char *name = json_string_value(json_object_get(json, "name"));
    struct mesh_material *m = &to->material;
    struct texture texture;
    *to = (struct gltf_material){.color = {1, 1, 1, 1}};
    m->is_linear = true;
    snprintf(m->name, sizeof(m->name), "%s", name ? name : "");
    gltf_numbers(g, base, old ? "diffuseFactor" : "baseColorFactor", to->color,
                 4);
    if (!read_texture(
            g, mesh,
            gltf_member(g, base, old ? "diffuseTexture" : "baseColorTexture"),
            &texture))
        return false;
    m->texture = texture.number;
    m->wrap_u = texture.wrap[0];
    m->wrap_v = texture.wrap[1];
    to->place = texture.place;
    m->is_unlit = gltf_member(g, json, "extensions.KHR_materials_unlit");
    read_alpha(g, json, m);
    return (m->is_unlit || read_glow(g, mesh, json, &texture, to)) && g->good;
}
