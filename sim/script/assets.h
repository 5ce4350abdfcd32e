/* What the commands of a script name besides numbers: fonts, pictures and
 * texts, loaded when the script is read. Only for script*.c. */
#ifndef SIM_SCRIPT_ASSETS_H
#define SIM_SCRIPT_ASSETS_H

#include "core/asset/font_asset.h"
#include "sim/script/commands.h"

/* All zero at first. Pictures are surfaces of argb8888 pixels. */
struct script_assets {
    struct pel_font_asset *fonts;
    struct pel_surface *pictures;
    char **texts;
    struct script_mesh **meshes; /* script_meshes.h */
    size_t font_count, picture_count, text_count, mesh_count;
};

/* Each adds one and gives its index. False, with a message that names the line,
 * when it cannot. Files are sought beside the script, unless their name begins
 * with a slash. */
bool script_add_font(const struct script_place *place, const char *word,
                     int32_t *index);
bool script_add_picture(const struct script_place *place, const char *word,
                        int32_t *index);
bool script_add_text(const struct script_place *place, const char *word,
                     int32_t *index);

/* The path of a file that can be read, as a text. */
bool script_add_file(const struct script_place *place, const char *word,
                     int32_t *index);

/* The file that a word names, if it can be read, in memory to be freed. NULL,
 * with a message. */
char *script_file(const struct script_place *place, const char *word);

void script_assets_free(struct script_assets *assets);

#endif
