#include "sim/mesh/mesh.h"

#include <math.h>

#include "sim/mesh/quantize.h"
#include "sim/cli/message.h"
#include "sim/image/texture.h"

/* At the uv that the asset will have, so that a program which samples there
 * finds the same texel. */
static void sample(struct mesh *mesh, const struct picture *texture)
{
    const struct pel_quantization q = import_quantum_uv(mesh);
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        struct mesh_vertex *v = &mesh->vertex[i];
        double at[2];
        for (int k = 0; k < 2; k++) {
            const long number = import_quantised(&q, k, v->uv[k]);
            at[k] =
                ldexp(pel_quantization_value(&q, k, (int32_t)number), -q.shift);
        }
        v->color = texture_at(texture, at[0], at[1]);
    }
}

/* The mesh's own texture, if there is one that can be read. */
static void sample_own(struct mesh *mesh, const char *path)
{
    struct picture texture;
    bool loaded = false;
    if (!mesh->has_uv || (!mesh->texture_bytes && !mesh->texture))
        return;
    if (mesh->texture_bytes)
        loaded = texture_load_bytes(&texture, path, mesh->texture_bytes,
                                    mesh->texture_size);
    else
        loaded = texture_load(&texture, mesh->texture);
    if (!loaded) {
        message_error_at(path, 0, "its texture is left out");
        return;
    }
    sample(mesh, &texture);
    picture_free(&texture);
}

/* The texture that the user named. */
static bool sample_file(struct mesh *mesh, const char *path,
                        const char *texture)
{
    struct picture picture;
    if (!mesh->has_uv)
        return message_error_at(path, 0,
                                "the mesh has no texture coordinates, so "
                                "--texture-file cannot apply");
    if (!texture_load(&picture, texture))
        return false;
    sample(mesh, &picture);
    picture_free(&picture);
    return true;
}

bool mesh_paint(struct mesh *mesh, const char *path, const char *texture)
{
    if (texture)
        return sample_file(mesh, path, texture);
    if (!mesh->has_colors)
        sample_own(mesh, path);
    return true;
}
