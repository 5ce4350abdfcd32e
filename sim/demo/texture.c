/* The demo `texture`: triangles in one colour and with a texture, nearest and
 * bilinear, back to front. */
#include "sim/demo/mesh.h"

enum { SIZE = 512 };

/* The rule of this demo alone: nearest takes column floor(u (W - 1)) and row
 * floor(v (H - 1)). */
static void scale_uv(struct mesh *mesh, const struct picture *texture)
{
    const double w = texture->width, h = texture->height;
    for (uint32_t i = 0; i < mesh->vertices; i++) {
        mesh->vertex[i].uv[0] *= (w - 1) / w;
        mesh->vertex[i].uv[1] *= (h - 1) / h;
    }
}

/* The size of the texture is known when it has been read; then the mesh is
 * quantised once more, with what that scales. */
static bool make_scaled(struct model *model, struct mesh *mesh,
                        const struct model_source *source,
                        struct demo_result *result)
{
    struct model scaled;
    if (!model_make(model, mesh) || !model_add_texture(model, mesh, source) ||
        !demo_mesh_add_texture(model, result))
        return false;
    scale_uv(mesh, &model->texture);
    if (!model_make(&scaled, mesh))
        return false;
    scaled.texture = model->texture;
    scaled.texture_opaque = model->texture_opaque;
    model->texture = (struct picture){0};
    model_free(model);
    *model = scaled;
    return true;
}

static struct scene_settings settings_of(int texture)
{
    struct scene_settings s = scene_default;
    s.camera.width = s.camera.height = SIZE;
    s.lit = SCENE_UNLIT;
    s.shade = texture == SCENE_TEXTURE_NONE ? SCENE_FLAT : SCENE_GOURAUD;
    s.mapping =
        texture == SCENE_TEXTURE_NONE ? SCENE_MAP_VERTICES : SCENE_MAP_AFFINE;
    s.texture = texture == SCENE_TEXTURE_NONE ? SCENE_TEXTURE_NEAREST
                                              : (enum scene_texture)texture;
    return s;
}

static bool draw(struct demo_result *result, int texture)
{
    struct model_source source;
    struct model model = {.plain = true};
    struct mesh mesh;
    const struct scene_settings settings = settings_of(texture);
    if (!demo_mesh_load(&mesh, &source, result))
        return false;
    const bool done = make_scaled(&model, &mesh, &source, result) &&
                      demo_mesh_draw(&model, &settings, result);
    model_free(&model);
    mesh_free(&mesh);
    return done;
}

const struct demo demo_texture[] = {
    {"texture-flat",
     "Triangles in one colour each: the mean of the texels at their vertices.",
     draw, SCENE_TEXTURE_NONE},
    {"texture-nearest",
     "The texture on every triangle, the nearest texel for each pixel. What "
     "that does to enlarged texels, the scenes textures and meshes show.",
     draw, SCENE_TEXTURE_NEAREST},
    {"texture-bilinear", "The same with the four texels around it mixed.", draw,
     SCENE_TEXTURE_BILINEAR},
    {NULL, NULL, NULL, 0},
};
