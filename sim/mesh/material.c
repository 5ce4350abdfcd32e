#ifdef HAVE_ASSIMP
#include "sim/mesh/mesh.h"

#include <assimp/GltfMaterial.h>
#include <assimp/scene.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/list.h"
#include "sim/mesh/mend.h"

static unsigned byte_of(double value, bool linear)
{
    if (linear)
        value = value <= 0.0031308 ? value * 12.92
                                   : 1.055 * pow(value, 1 / 2.4) - 0.055;
    return value > 0 ? value < 1 ? (unsigned)(value * 255 + 0.5) : 255 : 0;
}

pel_color material_byte_color(const struct aiColor4D *c, bool linear)
{
    const double channel[3] = {(double)c->r, (double)c->g, (double)c->b};
    unsigned byte[3];
    for (int k = 0; k < 3; k++)
        byte[k] = byte_of(channel[k], linear);
    return PEL_RGB(byte[0], byte[1], byte[2]);
}

bool material_is_linear(const struct aiMaterial *from)
{
    struct aiString mode;
    return aiGetMaterialString(from, AI_MATKEY_GLTF_ALPHAMODE, &mode) ==
           aiReturn_SUCCESS;
}

static pel_color with_alpha(pel_color color, double alpha)
{
    return (color & 0xFFFFFFu) | (pel_color)byte_of(alpha, false) << 24;
}

/* glTF says it; elsewhere alpha is blended where there is an opacity, or a
 * texture of it. Many files have 0 where they mean nothing by it. */
static void read_alpha(struct mesh_material *to, const struct aiMaterial *from,
                       double alpha)
{
    struct aiString mode;
    float value = 1;
    unsigned flags = 0, n = 1;
    aiGetMaterialFloatArray(from, AI_MATKEY_OPACITY, &value, NULL);
    aiGetMaterialIntegerArray(from, AI_MATKEY_TEXFLAGS_DIFFUSE(0),
                              (int *)&flags, &n);
    if (aiGetMaterialString(from, AI_MATKEY_GLTF_ALPHAMODE, &mode) ==
        aiReturn_SUCCESS) {
        to->alpha = strcmp(mode.data, "BLEND") == 0  ? MESH_BLENDED
                    : strcmp(mode.data, "MASK") == 0 ? MESH_CUT_OUT
                                                     : MESH_OPAQUE;
        value = 0.5f;
        aiGetMaterialFloatArray(from, AI_MATKEY_GLTF_ALPHACUTOFF, &value, NULL);
        /* A float may be a little more than the number that was meant. */
        to->cutoff =
            (uint8_t)ceil(fmin(fmax((double)value, 0), 1) * 255 - 1e-4);
    } else {
        alpha = (double)value > 0 && (double)value < 1 ? (double)value : 1;
        if (alpha < 1 || (flags & aiTextureFlags_UseAlpha) ||
            aiGetMaterialTextureCount(from, aiTextureType_OPACITY) > 0)
            to->alpha = MESH_BLENDED;
    }
    to->tint = with_alpha(to->tint, to->alpha == MESH_CUT_OUT ? alpha : 1);
    if (to->alpha == MESH_BLENDED)
        to->color = with_alpha(to->color, alpha);
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
    struct mesh_texture new = {
        is_inner ? strdup(name) : mend_path_beside(path, name), NULL, 0};
    if (!new.path)
        return message_error("no memory for the name of a texture");
    for (*number = 1; *number <= mesh->textures; ++*number)
        if (strcmp(mesh->texture[*number - 1].path, new.path) == 0) {
            free(new.path);
            return true;
        }
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
    const bool linear = material_is_linear(from);
    aiGetMaterialColor(from, AI_MATKEY_COLOR_DIFFUSE, &color);
    aiGetMaterialString(from, AI_MATKEY_NAME, &name);
    snprintf(to->name, sizeof(to->name), "%.*s", (int)sizeof(to->name) - 1,
             name.data);
    to->color = material_byte_color(&color, linear);
    if (linear) /* elsewhere a texture takes the place of the color */
        to->tint = to->color;
    read_alpha(to, from, (double)color.a);
    return read_texture(to, mesh, scene, from, path);
}

#else
typedef int material_needs_assimp;
#endif
