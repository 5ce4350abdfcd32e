#include "sim/mesh/mesh.h"

#include <assimp/scene.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/list.h"
#include "sim/image/picture.h"
#include "sim/mesh/mend.h"

static unsigned byte_of(double value)
{
    return value > 0 ? value < 1 ? (unsigned)(value * 255 + 0.5) : 255 : 0;
}

pel_color material_byte_color(const struct aiColor4D *c)
{
    return PEL_RGB(byte_of((double)c->r), byte_of((double)c->g),
                   byte_of((double)c->b));
}

/* Alpha is blended where there is an opacity, or a texture of it. Many files
 * have 0 where they mean nothing by it. */
static void read_alpha(struct mesh_material *to, const struct aiMaterial *from)
{
    float value = 1;
    unsigned flags = 0, n = 1;
    aiGetMaterialFloatArray(from, AI_MATKEY_OPACITY, &value, NULL);
    aiGetMaterialIntegerArray(from, AI_MATKEY_TEXFLAGS_DIFFUSE(0),
                              (int *)&flags, &n);
    const double alpha = value > 0 && value < 1 ? (double)value : 1;
    if (alpha < 1 || (flags & aiTextureFlags_UseAlpha) ||
        aiGetMaterialTextureCount(from, aiTextureType_OPACITY) > 0) {
        to->alpha = MESH_BLENDED;
        to->color = (to->color & 0xFFFFFFu) | (pel_color)byte_of(alpha) << 24;
    }
}

/* A texture file inside the mesh file: the name is * and its number. Not there,
 * or bare texels, which no format has: its bytes are NULL. */
static bool copy_inner(struct mesh_texture *to, const struct aiScene *scene,
                       const char *name)
{
    const unsigned long i = strtoul(name + 1, NULL, 10);
    if (i >= scene->mNumTextures || scene->mTextures[i]->mHeight != 0)
        return true;
    to->size = scene->mTextures[i]->mWidth;
    to->bytes = malloc(to->size);
    if (!to->bytes)
        return message_error("no memory for a texture of %zu bytes", to->size);
    memcpy(to->bytes, scene->mTextures[i]->pcData, to->size);
    return true;
}

static bool add_texture(struct mesh *mesh, const struct aiScene *scene,
                        char *name, const char *path, uint32_t *number)
{
    const bool is_inner = name[0] == '*';
    const bool is_part = path_has_ending(path, " .3mf ");
    struct mesh_texture new = {
        is_inner || is_part ? strdup(name) : mend_path_beside(path, name), NULL,
        0};
    if (!new.path)
        return message_error("no memory for the name of a texture");
    for (*number = 1; *number <= mesh->textures; ++*number)
        if (strcmp(mesh->texture[*number - 1].path, new.path) == 0) {
            free(new.path);
            return true;
        }
    if (is_part)
        new.bytes = mend_3mf_part(path, name, &new.size);
    if ((!is_inner || copy_inner(&new, scene, name)) &&
        list_add(&mesh->texture, &mesh->textures, &new, sizeof(new)))
        return true;
    free(new.path);
    free(new.bytes);
    return false;
}

static enum pel_wrap wrap_of(enum aiTextureMapMode mode)
{
    return mode == aiTextureMapMode_Wrap     ? PEL_WRAP_REPEAT
           : mode == aiTextureMapMode_Mirror ? PEL_WRAP_MIRROR
                                             : PEL_WRAP_CLAMP;
}

static bool read_texture(struct mesh_material *to, struct mesh *mesh,
                         const struct aiScene *scene,
                         const struct aiMaterial *from, const char *path)
{
    static const enum aiTextureType types[] = {aiTextureType_DIFFUSE,
                                               aiTextureType_BASE_COLOR};
    struct aiString name;
    for (int i = 0; i < 2; i++) {
        enum aiTextureMapMode mode[3] = {aiTextureMapMode_Wrap,
                                         aiTextureMapMode_Wrap};
        if (aiGetMaterialTexture(from, types[i], 0, &name, NULL, NULL, NULL,
                                 NULL, mode, NULL) != aiReturn_SUCCESS)
            continue;
        to->wrap_u = wrap_of(mode[0]);
        to->wrap_v = wrap_of(mode[1]);
        to->is_placed =
            sscanf(name.data, MEND_PLACE, &to->place[0], &to->place[1],
                   &to->place[2], &to->place[3]) == 4;
        return add_texture(
            mesh, scene, to->is_placed ? strrchr(name.data, 1) + 1 : name.data,
            path, &to->texture);
    }
    return true;
}

bool material_read(struct mesh_material *to, struct mesh *mesh,
                   const struct aiScene *scene, const struct aiMaterial *from,
                   const char *path)
{
    struct aiColor4D color = {0.8f, 0.8f, 0.8f, 1};
    struct aiString name = {0, ""};
    aiGetMaterialColor(from, AI_MATKEY_COLOR_DIFFUSE, &color);
    aiGetMaterialString(from, AI_MATKEY_NAME, &name);
    snprintf(to->name, sizeof(to->name), "%.*s", (int)sizeof(to->name) - 1,
             name.data);
    to->color = material_byte_color(&color);
    read_alpha(to, from);
    return read_texture(to, mesh, scene, from, path);
}
