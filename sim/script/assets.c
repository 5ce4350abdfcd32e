#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/format/argb8888.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"
#include "sim/cli/text_line.h"
#include "sim/font/asset.h"
#include "sim/font/outline_asset.h"
#include "sim/icon/icon.h"
#include "sim/image/texture.h"
#include "sim/script/parser.h"

/* The path of a file that can be read, malloc'ed. NULL, with a message. */
static char *path_of(const struct script_parser *p, const char *name)
{
    const char *slash = strrchr(p->path, '/');
    const int folder = slash && *name != '/' ? (int)(slash - p->path) + 1 : 0;
    char *path;
    if (asprintf(&path, "%.*s%s", folder, p->path,
                 folder ? name : file_named(name)) < 0) {
        message_error("out of memory");
        return NULL;
    }
    if (access(path, R_OK) == 0)
        return path;
    ERROR_AT(p,
             "%s: %s cannot be read (%s): expected a file, named from the "
             "script's folder",
             p->command->name, path, strerror(errno));
    free(path);
    return NULL;
}

static bool load_font(struct script_asset *asset, const char *path)
{
    const struct font_options options = {.size = asset->size ? asset->size
                                                             : FONT_SIZE,
                                         .bits = asset->size > 0 ? 4 : 1,
                                         .outline = asset->size < 0};
    struct font font;
    bool done = font_load(&font, path, &options);
    if (done && font.em)
        done = outline_add_box(&font) &&
               outline_asset_make(&asset->outlines, &font, path);
    else if (done)
        done = font_asset_make(&asset->font, &font, path);
    font_free(&font);
    return done;
}

/* The picture's colors as bytes B, G, R, A. */
static bool load_picture(struct pel_surface *surface, const char *path)
{
    struct picture picture;
    if (!texture_load(&picture, path))
        return false;
    const size_t n = (size_t)picture.width * (size_t)picture.height;
    uint8_t *bytes = (uint8_t *)picture.pixels;
    for (size_t i = 0; i < n; i++) {
        const pel_color color = picture.pixels[i];
        for (int shift = 0; shift < 32; shift += 8)
            *bytes++ = (uint8_t)(color >> shift);
    }
    pel_surface_init(surface, &pel_argb8888, picture.pixels, 4 * n,
                     &(struct pel_rect){0, 0, picture.width, picture.height});
    return true;
}

/* The model that an earlier line has read, or NULL. */
static const struct model *find_model(const struct script *script,
                                      const struct model_source *of)
{
    for (size_t i = 0; i < script->asset_count; i++) {
        const struct script_mesh *mesh = script->assets[i].mesh;
        const struct model_source *s = mesh ? &mesh->source : NULL;
        if (s && strcmp(s->path, of->path) == 0 &&
            !s->texture == !of->texture &&
            (!s->texture || strcmp(s->texture, of->texture) == 0) &&
            s->without_texture == of->without_texture &&
            s->smooth_normals == of->smooth_normals &&
            s->has_crease == of->has_crease && s->crease == of->crease)
            return mesh->scene.model;
    }
    return NULL;
}

static bool load_mesh(const struct script_parser *p, struct script_mesh *mesh,
                      const char *path)
{
    const struct script_scene *set = &p->scene;
    mesh->source = (struct model_source){
        .path = path,
        .texture =
            set->texture < 0 ? NULL : p->script->assets[set->texture].text,
        .without_texture = set->settings.texture == SCENE_TEXTURE_NONE,
        .smooth_normals = set->smooth_normals,
        .has_crease = set->has_crease,
        .crease = set->crease};
    const struct model *model = find_model(p->script, &mesh->source);
    return (model || model_load(&mesh->model, &mesh->source)) &&
           scene_init(&mesh->scene, model ? model : &mesh->model) &&
           scene_prepare(&mesh->scene, &set->settings);
}

static bool load(const struct script_parser *p, enum script_kind kind,
                 const char *name, struct script_asset *asset)
{
    if (kind == KIND_FONT)
        return load_font(asset, name);
    if (kind == KIND_PICTURE)
        return load_picture(&asset->picture, name);
    if (kind == KIND_ICON)
        return icon_load(&asset->icon, name);
    if (kind == KIND_MESH) {
        asset->mesh = calloc(1, sizeof *asset->mesh);
        return asset->mesh ? load_mesh(p, asset->mesh, name)
                           : message_error("out of memory");
    }
    asset->text = strdup(name);
    return asset->text || message_error("out of memory");
}

static void free_asset(const struct script_asset *asset)
{
    struct pel_font_asset font = asset->font;
    struct pel_outline_font_asset outlines = asset->outlines;
    struct pel_icon_asset icon = asset->icon;
    font_asset_free(&font);
    outline_asset_free(&outlines);
    icon_free(&icon);
    free(asset->picture.pixels);
    free(asset->path);
    free(asset->text);
    if (asset->mesh) {
        scene_free(&asset->mesh->scene);
        model_free(&asset->mesh->model);
    }
    free(asset->mesh);
}

/* Loads it, and takes the path. */
static bool add(struct script_parser *p, struct script_asset *asset,
                const char *name)
{
    struct script *script = p->script;
    message_place(p->path, p->line);
    const bool done =
        load(p, asset->kind, asset->path ? asset->path : name, asset) &&
        list_add(&script->assets, &script->asset_count, asset, sizeof *asset);
    message_place(NULL, 0);
    return done;
}

/* The font, picture or icon that an earlier line has named, or the next asset.
 */
static size_t find(const struct script *script, const struct script_asset *new)
{
    size_t i = new->kind == KIND_FONT || new->kind == KIND_PICTURE ||
                       new->kind == KIND_ICON
                   ? 0
                   : script->asset_count;
    while (i < script->asset_count &&
           (script->assets[i].kind != new->kind ||
            script->assets[i].size != new->size ||
            strcmp(script->assets[i].path, new->path) != 0))
        i++;
    return i;
}

/* The number before a smooth font's file, which is checked later. */
static int size_of(const struct script_parser *p, enum script_kind kind)
{
    const struct script *script = p->script;
    if (strcmp(p->command->name, "font outline") == 0)
        return -1;
    return kind == KIND_FONT && *p->command->kinds == KIND_COUNT
               ? pel_max(1, pel_min(script->values[script->value_count - 1],
                                    FONT_SIZE_MAX))
               : 0;
}

/* Quoted words begin with their quote. */
bool script_add_asset(struct script_parser *p, enum script_kind kind,
                      const char *word, int32_t *index)
{
    struct script_asset asset = {.kind = kind, .size = size_of(p, kind)};
    const char *name = word + (*word == '"');
    const bool builtin = kind == KIND_MESH && mesh_is_builtin(name);
    if (kind == KIND_TEXT && *word != '"')
        return ERROR_AT(p, "%s: %s: expected a text in quotes, \"...\"",
                        p->command->name, word);
    if (kind != KIND_TEXT)
        asset.path = builtin ? strdup(name) : path_of(p, name);
    if (!asset.path && kind != KIND_TEXT)
        return builtin && message_error("out of memory");
    *index = (int32_t)find(p->script, &asset);
    const bool is_new = (size_t)*index == p->script->asset_count;
    const bool done = !is_new || add(p, &asset, name);
    if (!is_new || !done)
        free_asset(&asset);
    return done;
}

void script_free_assets(struct script *script)
{
    for (size_t i = 0; i < script->asset_count; i++)
        free_asset(&script->assets[i]);
    free(script->assets);
}
