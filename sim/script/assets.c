#include "sim/script/assets.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/format/argb8888.h"
#include "sim/font/asset.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"
#include "sim/image/texture.h"

static bool out_of_memory(const struct script_place *place)
{
    return ERROR_AT(place, "out of memory");
}

/* Quoted words begin with their quote. */
static const char *name_of(const char *word)
{
    return word + (*word == '"');
}

/* The path of a file that a word names and that can be read, malloc'ed. NULL,
 * with a message. */
static char *path_of(const struct script_place *place, const char *word)
{
    const char *slash = strrchr(place->path, '/'), *name = name_of(word);
    const int folder =
        slash && *name != '/' ? (int)(slash - place->path) + 1 : 0;
    char *path;
    if (asprintf(&path, "%.*s%s", folder, place->path, name) < 0) {
        out_of_memory(place);
        return NULL;
    }
    if (access(path, R_OK) == 0)
        return path;
    ERROR_AT(place,
             "%s: %s cannot be read (%s): expected a file, named from the "
             "script's folder",
             place->command->name, path, strerror(errno));
    free(path);
    return NULL;
}

/* Loads one more entry of a list from a path, which it frees, with messages
 * that name the script's line. */
static bool add(const struct script_place *place, char *path,
                bool (*load)(const struct script_place *place,
                             const char *path),
                size_t *count, int32_t *index)
{
    message_place(place->path, place->line);
    const bool done = path && load(place, path);
    message_place(NULL, 0);
    free(path);
    *index = (int32_t)*count;
    *count += done;
    return done;
}

static bool load_font(const struct script_place *place, const char *path)
{
    struct script_assets *a = place->assets;
    struct font font;
    struct pel_font_asset *list =
        list_grow(a->fonts, a->font_count, sizeof(*list));
    if (!list)
        return false;
    a->fonts = list;
    if (!font_load(&font, path))
        return false;
    const bool done = font_asset_make(&list[a->font_count], &font, path);
    font_free(&font);
    return done;
}

/* The picture's colors as bytes B, G, R, A. */
static bool make_surface(struct pel_surface *surface,
                         const struct picture *picture)
{
    const size_t n = (size_t)picture->width * (size_t)picture->height;
    uint8_t *bytes = malloc(4 * n), *p = bytes;
    if (!bytes)
        return message_error("out of memory");
    for (size_t i = 0; i < n; i++)
        for (int shift = 0; shift < 32; shift += 8)
            *p++ = (uint8_t)(picture->pixels[i] >> shift);
    pel_surface_init(surface, &pel_argb8888, bytes, 4 * n,
                     &(struct pel_rect){0, 0, picture->width, picture->height});
    return true;
}

static bool load_picture(const struct script_place *place, const char *path)
{
    struct script_assets *a = place->assets;
    struct picture picture;
    struct pel_surface *list =
        list_grow(a->pictures, a->picture_count, sizeof(*list));
    if (!list)
        return false;
    a->pictures = list;
    if (!texture_load(&picture, path))
        return false;
    const bool done = make_surface(&list[a->picture_count], &picture);
    picture_free(&picture);
    return done;
}

static bool load_text(const struct script_place *place, const char *text)
{
    struct script_assets *a = place->assets;
    char **list = list_grow(a->texts, a->text_count, sizeof(*list));
    if (!list)
        return false;
    a->texts = list;
    list[a->text_count] = strdup(text);
    return list[a->text_count] || message_error("out of memory");
}

static void free_mesh(struct script_mesh *mesh)
{
    scene_free(&mesh->scene);
    model_free(&mesh->model);
    free(mesh);
}

static bool load_mesh(const struct script_place *place, const char *path)
{
    struct script_assets *a = place->assets;
    const struct script_scene *set = place->scene;
    const struct model_source source = {
        .path = path,
        .texture = set->texture < 0 ? NULL : a->texts[set->texture],
        .without_texture = set->settings.texture == SCENE_TEXTURE_NONE,
        .smooth_normals = set->smooth_normals,
        .has_crease = set->has_crease,
        .crease = set->crease};
    struct script_mesh **list =
        list_grow(a->meshes, a->mesh_count, sizeof(struct script_mesh *));
    if (!list)
        return false;
    a->meshes = list;
    struct script_mesh *mesh = calloc(1, sizeof(*mesh));
    if (!mesh)
        return message_error("out of memory");
    list[a->mesh_count] = mesh;
    if (model_load(&mesh->model, &source) &&
        scene_init(&mesh->scene, &mesh->model) &&
        scene_prepare(&mesh->scene, &set->settings))
        return true;
    free_mesh(mesh);
    return false;
}

bool script_add_font(const struct script_place *place, const char *word,
                     int32_t *index)
{
    return add(place, path_of(place, word), load_font,
               &place->assets->font_count, index);
}

bool script_add_picture(const struct script_place *place, const char *word,
                        int32_t *index)
{
    return add(place, path_of(place, word), load_picture,
               &place->assets->picture_count, index);
}

bool script_add_file(const struct script_place *place, const char *word,
                     int32_t *index)
{
    return add(place, path_of(place, word), load_text,
               &place->assets->text_count, index);
}

bool script_add_mesh(const struct script_place *place, const char *word,
                     int32_t *index)
{
    const bool is_builtin = mesh_is_builtin(name_of(word));
    return add(place, is_builtin ? strdup(name_of(word)) : path_of(place, word),
               load_mesh, &place->assets->mesh_count, index);
}

bool script_add_text(const struct script_place *place, const char *word,
                     int32_t *index)
{
    if (*word != '"')
        return ERROR_AT(place, "%s: %s: expected a text in quotes, \"...\"",
                        place->command->name, word);
    return add(place, strdup(word + 1), load_text, &place->assets->text_count,
               index);
}

void script_assets_free(struct script_assets *assets)
{
    for (size_t i = 0; i < assets->font_count; i++)
        font_asset_free(&assets->fonts[i]);
    for (size_t i = 0; i < assets->picture_count; i++)
        free(assets->pictures[i].pixels);
    for (size_t i = 0; i < assets->text_count; i++)
        free(assets->texts[i]);
    for (size_t i = 0; i < assets->mesh_count; i++)
        free_mesh(assets->meshes[i]);
    free(assets->meshes);
    free(assets->fonts);
    free(assets->pictures);
    free(assets->texts);
    *assets = (struct script_assets){.fonts = NULL};
}
