/* Scenes: a script, read into a list of things to draw. Reading checks
 * everything, so that drawing cannot fail half-way and a list can be replayed
 * for every band. */
#ifndef SIM_SCENE_H
#define SIM_SCENE_H

#include "canvas.h"

struct scene_command;
struct scene_assets;

/* One line of the script that draws, or that changes how. */
struct scene_item {
    const struct scene_command *command;
    long line;
    size_t first; /* of the scene's values */
    size_t count;
};

struct scene {
    const char *path; /* of the script, the caller's; "-" is standard input */
    const struct pel_format *format;
    int width, height;
    struct scene_item *items;
    size_t item_count;
    int32_t *values; /* arguments of all items; colours as their bits */
    size_t value_count;
    size_t polygon_max;          /* vertices of the largest polygon */
    struct scene_assets *assets; /* fonts, pictures and texts that it names */
    char *caption; /* the comment that the script begins with, or "" */
};

/* Reads a script (sim/scenes/README.md). `format`, when not NULL, replaces that
 * of its canvas line. False, with a message on standard error that names file
 * and line, when it is not right; the scene is then empty. */
bool scene_load(struct scene *scene, const char *path,
                const struct pel_format *format);

void scene_free(struct scene *scene);

/* Does it move pixels that have been drawn? Then it cannot be drawn in bands or
 * by several threads. */
bool scene_needs_whole(const struct scene *scene);

/* Draws the scene onto a canvas of its size and format. rows >= 0 replaces
 * every `bands` line of the script (0 draws it whole), -1 follows them. False,
 * with a message and nothing drawn, when bands are not possible; or when memory
 * is short. */
bool scene_draw(const struct scene *scene, struct canvas *canvas, int rows);

#endif
