#include "sim/script/assets.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/format/argb8888.h"
#include "sim/font/asset.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"
#include "sim/script/meshes.h"
#include "sim/image/texture.h"

static bool out_of_memory(const struct script_place *place)
{
    return message_error_at(place->path, place->line, "out of memory");
}

/* Quoted words begin with their quote. */
char *script_file(const struct script_place *place, const char *word)
{
    const char *slash = strrchr(place->path, '/');
    const char *name = word + (*word == '"');
    const size_t folder =
        slash && *name != '/' ? (size_t)(slash - place->path) + 1 : 0;
    char *path = malloc(folder + strlen(name) + 1);
    if (!path) {
        out_of_memory(place);
        return NULL;
    }
    memcpy(path, place->path, folder);
    strcpy(path + folder, name);
    if (access(path, R_OK) == 0)
        return path;
    message_error_at(place->path, place->line,
                     "%s: %s cannot be read (%s); a file, named from where "
                     "the script is, would be right",
                     place->command->name, path, strerror(errno));
    free(path);
    return NULL;
}

static bool load_font(struct pel_font_asset *asset, const char *path)
{
    struct font font;
    if (!font_load(&font, path))
        return false;
    bool done = font_asset_make(asset, &font, path);
    font_free(&font);
    return done;
}

bool script_add_font(const struct script_place *place, const char *word,
                     int32_t *index)
{
    struct script_assets *a = place->assets;
    struct pel_font_asset *list =
        list_grow(a->fonts, a->font_count, sizeof(*list));
    char *path = script_file(place, word);
    bool done = false;
    if (list)
        a->fonts = list;
    message_place(place->path, place->line);
    if (list && path)
        done = load_font(&list[a->font_count], path);
    message_place(NULL, 0);
    if (done)
        *index = (int32_t)a->font_count++;
    free(path);
    return done;
}

/* The picture's colours as bytes B, G, R, A. */
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

static bool load_picture(struct pel_surface *surface, const char *path)
{
    struct picture picture;
    if (!texture_load(&picture, path))
        return false;
    bool done = make_surface(surface, &picture);
    picture_free(&picture);
    return done;
}

bool script_add_picture(const struct script_place *place, const char *word,
                        int32_t *index)
{
    struct script_assets *a = place->assets;
    struct pel_surface *list =
        list_grow(a->pictures, a->picture_count, sizeof(*list));
    char *path = script_file(place, word);
    bool done = false;
    if (list)
        a->pictures = list;
    message_place(place->path, place->line);
    if (list && path)
        done = load_picture(&list[a->picture_count], path);
    message_place(NULL, 0);
    if (done)
        *index = (int32_t)a->picture_count++;
    free(path);
    return done;
}

/* Takes `text` over, also when it fails. */
static bool add_text(const struct script_place *place, char *text,
                     int32_t *index)
{
    struct script_assets *a = place->assets;
    char **list =
        text ? list_grow(a->texts, a->text_count, sizeof(*list)) : NULL;
    if (!list) {
        free(text);
        return false;
    }
    a->texts = list;
    list[a->text_count] = text;
    *index = (int32_t)a->text_count++;
    return true;
}

bool script_add_text(const struct script_place *place, const char *word,
                     int32_t *index)
{
    if (*word != '"')
        return message_error_at(place->path, place->line,
                                "%s: %s must be a text in quotes: \"...\"",
                                place->command->name, word);
    char *text = strdup(word + 1);
    return text ? add_text(place, text, index) : out_of_memory(place);
}

bool script_add_file(const struct script_place *place, const char *word,
                     int32_t *index)
{
    return add_text(place, script_file(place, word), index);
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
        script_mesh_free(assets->meshes[i]);
    free(assets->meshes);
    free(assets->fonts);
    free(assets->pictures);
    free(assets->texts);
    *assets = (struct script_assets){.fonts = NULL};
}
