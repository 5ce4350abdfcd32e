/* What the commands of a scene name besides numbers: fonts, pictures and texts,
 * loaded when the script is read. Only for scene*.c. */
#ifndef SIM_SCENE_ASSETS_H
#define SIM_SCENE_ASSETS_H

#include "core/asset/font_asset.h"
#include "scene_commands.h"

/* All zero at first. Pictures are surfaces of argb8888 pixels. */
struct scene_assets {
    struct pel_font_asset *fonts;
    struct pel_surface *pictures;
    char **texts;
    struct scene_mesh **meshes; /* scene_meshes.h */
    size_t font_count, picture_count, text_count, mesh_count;
};

/* Each adds one and gives its index. False, with a message that names the line,
 * when it cannot. Files are sought beside the script, unless their name begins
 * with a slash. */
bool scene_add_font(const struct scene_place *place, const char *word,
                    int32_t *index);
bool scene_add_picture(const struct scene_place *place, const char *word,
                       int32_t *index);
bool scene_add_text(const struct scene_place *place, const char *word,
                    int32_t *index);

/* The path of a file that can be read, as a text. */
bool scene_add_file(const struct scene_place *place, const char *word,
                    int32_t *index);

/* The file that a word names, if it can be read, in memory to be freed. NULL,
 * with a message. */
char *scene_file(const struct scene_place *place, const char *word);

void scene_assets_free(struct scene_assets *assets);

#endif
