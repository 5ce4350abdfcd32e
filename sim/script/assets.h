/* Fonts, pictures, texts and meshes that commands of scripts name, loaded when
 * the script is read. Only for sim/script. */
#ifndef SIM_SCRIPT_ASSETS_H
#define SIM_SCRIPT_ASSETS_H

#include "core/asset/font_asset.h"
#include "sim/render/scene.h"
#include "sim/script/commands.h"

/* Settings of the meshes that follow. */
struct script_scene {
    struct scene_settings settings;
    int32_t texture; /* of script_assets.texts: its file; -1: the mesh's own */
    bool smooth_normals, has_crease;
    double crease;
};

/* Never moved: a scene points into itself. */
struct script_mesh {
    struct model model;
    struct scene scene;
};

/* All zero at first. Pictures are surfaces of argb8888 pixels. */
struct script_assets {
    struct pel_font_asset *fonts;
    struct pel_surface *pictures;
    char **texts;
    struct script_mesh **meshes;
    size_t font_count, picture_count, text_count, mesh_count;
};

/* Each adds one and gives its index; script_add_file the path of a readable
 * file, as a text; script_add_mesh prepares its mesh as place->scene says.
 * False, with a message that names the line, when it cannot. Files are sought
 * beside the script, unless their name begins with a slash. */
bool script_add_font(const struct script_place *place, const char *word,
                     int32_t *index);
bool script_add_picture(const struct script_place *place, const char *word,
                        int32_t *index);
bool script_add_text(const struct script_place *place, const char *word,
                     int32_t *index);
bool script_add_file(const struct script_place *place, const char *word,
                     int32_t *index);
bool script_add_mesh(const struct script_place *place, const char *word,
                     int32_t *index);

void script_assets_free(struct script_assets *assets);

#endif
