#include "mesh.h"

#include "message.h"
#include "texture.h"

static void sample(struct mesh *mesh, const struct picture *texture)
{
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        struct mesh_vertex *v = &mesh->vertex[i];
        v->color = texture_at(texture, v->uv[0], v->uv[1]);
    }
}

/* The mesh's own texture; false when there is none that can be read. */
static bool sample_own(struct mesh *mesh, const char *path)
{
    struct picture texture;
    bool loaded = false;
    if (!mesh->has_uv)
        return false;
    if (mesh->texture_bytes)
        loaded = texture_load_bytes(&texture, path, mesh->texture_bytes,
                                    mesh->texture_size);
    else if (mesh->texture)
        loaded = texture_load(&texture, mesh->texture);
    if (!loaded) {
        if (mesh->texture_bytes || mesh->texture)
            message_error_at(path, 0, "its texture is left out");
        return false;
    }
    sample(mesh, &texture);
    picture_free(&texture);
    return true;
}

/* The texture that the user named. */
static bool sample_file(struct mesh *mesh, const char *path,
                        const char *texture)
{
    struct picture picture;
    if (!mesh->has_uv)
        return message_error_at(path, 0,
                                "the mesh has no texture coordinates, so "
                                "--texture cannot apply");
    if (!texture_load(&picture, texture))
        return false;
    sample(mesh, &picture);
    picture_free(&picture);
    return true;
}

/* Light falls from above, from the left and from the viewer's side: full where
 * the normal points there, a third on the far side. */
static pel_color lighten(pel_color color, const double n[3])
{
    static const double light[3] = {-0.48, 0.64, 0.6};
    double cosine = n[0] * light[0] + n[1] * light[1] + n[2] * light[2];
    double gain = 0.333 + 0.333 * (1 + cosine);
    return PEL_RGB(pel_red(color) * gain, pel_green(color) * gain,
                   pel_blue(color) * gain);
}

bool mesh_paint(struct mesh *mesh, const char *path, const char *texture,
                bool lit)
{
    if (texture)
        return sample_file(mesh, path, texture);
    if (mesh->has_colors || sample_own(mesh, path) || !lit)
        return true;
    for (uint32_t i = 0; i < mesh->vertices; i++)
        mesh->vertex[i].color =
            lighten(mesh->vertex[i].color, mesh->vertex[i].normal);
    return true;
}
