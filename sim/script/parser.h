/* Reading a script line by line, and what its commands name: fonts, pictures,
 * texts and meshes. Only for sim/script. */
#ifndef SIM_SCRIPT_PARSER_H
#define SIM_SCRIPT_PARSER_H

#include "core/asset/icon_asset.h"
#include "core/asset/outline_font_asset.h"
#include "sim/render/scene.h"
#include "sim/script/commands.h"

/* Settings of the meshes that follow. */
struct script_scene {
    struct scene_settings settings;
    int32_t texture; /* the asset with its file's name; -1: the mesh's own */
    bool smooth_normals, has_crease;
    double crease;
};

/* Never moved: a scene points into itself. */
struct script_mesh {
    struct model_source source; /* its names are those of assets */
    struct model model;         /* empty where an earlier one is the same: */
    struct scene scene;         /* of either */
};

/* One of these, loaded when the script is read; the others are zero. */
struct script_asset {
    enum script_kind kind;
    char *path; /* of a font, a picture, an icon, a mesh, by which a line finds
                   it */
    struct pel_font_asset font;
    struct pel_outline_font_asset outlines;
    int size;                   /* px of a smooth font, or 0; -1: outlines */
    struct pel_surface picture; /* of argb8888 pixels */
    struct pel_icon_asset icon;
    char *text;
    struct script_mesh *mesh;
};

struct script_parser {
    struct script *script;
    const char *path; /* the script's */
    long line;
    char **words; /* of the line, in its own memory */
    size_t word_count;
    const struct script_command *command; /* of the line */
    bool by_vertex;                       /* paint vertex is in force */
    int32_t font, outlines;               /* in force, or -1 */
    struct script_scene scene;            /* in force */
};

/* One argument of a kind, from its word. False, with a message, when it is not
 * one. */
bool script_argument(struct script_parser *parser, enum script_kind kind,
                     const char *word, int32_t *value);

/* Adds an asset to the script, a mesh prepared as parser->scene says, and gives
 * its index. Files are sought beside the script, unless their name begins with
 * a slash. False, with a message. */
bool script_add_asset(struct script_parser *parser, enum script_kind kind,
                      const char *word, int32_t *index);
void script_free_assets(struct script *script);

/* Finds parser->command, the one that the line begins with, and how many words
 * its name has. False, with a message that says which ones there are. */
bool script_find_command(struct script_parser *parser, size_t *words);

#endif
