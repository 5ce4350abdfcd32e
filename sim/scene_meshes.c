#include "scene_meshes.h"

#include <stdlib.h>
#include <string.h>

#include "message.h"
#include "scene_assets.h"

void scene_stage_init(struct scene_stage *stage, int32_t width, int32_t height)
{
    *stage = (struct scene_stage){.settings = stage_default, .texture = -1};
    stage->settings.camera.width = width;
    stage->settings.camera.height = height;
}

void scene_mesh_free(struct scene_mesh *mesh)
{
    if (!mesh)
        return;
    stage_free(&mesh->stage);
    model_free(&mesh->model);
    free(mesh);
}

static bool load(const struct scene_place *place, struct scene_mesh *mesh,
                 const char *path)
{
    const struct scene_stage *set = place->stage;
    const struct model_source source = {
        .path = path,
        .texture = set->texture < 0 ? NULL : place->assets->texts[set->texture],
        .without_texture = set->settings.texture == STAGE_TEXTURE_NONE,
        .smooth_normals = set->smooth_normals};
    return model_load(&mesh->model, &source) &&
           stage_init(&mesh->stage, &mesh->model) &&
           stage_prepare(&mesh->stage, &set->settings);
}

static char *path_of(const struct scene_place *place, const char *word)
{
    const char *name = word + (*word == '"');
    return mesh_is_builtin(name) ? strdup(name) : scene_file(place, word);
}

bool scene_add_mesh(const struct scene_place *place, const char *word,
                    int32_t *index)
{
    struct scene_assets *a = place->assets;
    struct scene_mesh *mesh = calloc(1, sizeof(*mesh));
    struct scene_mesh **list =
        realloc(a->meshes, (a->mesh_count + 1) * sizeof(struct scene_mesh *));
    char *path = path_of(place, word);
    bool done = false;
    if (list)
        a->meshes = list;
    message_place(place->path, place->line);
    if (mesh && list && path)
        done = load(place, mesh, path);
    else if (path)
        message_error("out of memory");
    message_place(NULL, 0);
    free(path);
    if (!done) {
        scene_mesh_free(mesh);
        return false;
    }
    *index = (int32_t)a->mesh_count;
    list[a->mesh_count++] = mesh;
    return true;
}
