#include "sim/script/meshes.h"

#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/script/assets.h"

void script_scene_init(struct script_scene *scene, int32_t width,
                       int32_t height)
{
    *scene = (struct script_scene){.settings = scene_default, .texture = -1};
    scene->settings.camera.width = width;
    scene->settings.camera.height = height;
}

void script_mesh_free(struct script_mesh *mesh)
{
    if (!mesh)
        return;
    scene_free(&mesh->scene);
    model_free(&mesh->model);
    free(mesh);
}

static bool load(const struct script_place *place, struct script_mesh *mesh,
                 const char *path)
{
    const struct script_scene *set = place->scene;
    const struct model_source source = {
        .path = path,
        .texture = set->texture < 0 ? NULL : place->assets->texts[set->texture],
        .without_texture = set->settings.texture == SCENE_TEXTURE_NONE,
        .smooth_normals = set->smooth_normals};
    return model_load(&mesh->model, &source) &&
           scene_init(&mesh->scene, &mesh->model) &&
           scene_prepare(&mesh->scene, &set->settings);
}

static char *path_of(const struct script_place *place, const char *word)
{
    const char *name = word + (*word == '"');
    return mesh_is_builtin(name) ? strdup(name) : script_file(place, word);
}

bool script_add_mesh(const struct script_place *place, const char *word,
                     int32_t *index)
{
    struct script_assets *a = place->assets;
    struct script_mesh *mesh = calloc(1, sizeof(*mesh));
    struct script_mesh **list =
        realloc(a->meshes, (a->mesh_count + 1) * sizeof(struct script_mesh *));
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
        script_mesh_free(mesh);
        return false;
    }
    *index = (int32_t)a->mesh_count;
    list[a->mesh_count++] = mesh;
    return true;
}
