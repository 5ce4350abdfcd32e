/* Scripts: a script, read into a list of things to draw. Reading checks
 * everything, so that drawing cannot fail half-way and a list can be replayed
 * for every band. */
#ifndef SIM_SCRIPT_SCRIPT_H
#define SIM_SCRIPT_SCRIPT_H

#include <stdio.h>

#include "sim/image/canvas.h"

struct script_command;
struct script_asset;

/* One line of the script that draws, or that changes how. */
struct script_item {
    const struct script_command *command;
    long line;
    size_t first; /* of the script's values */
    size_t count;
};

struct script {
    const char *path; /* of the script, the caller's; "-" is standard input */
    const struct pel_format *format;
    int width, height;
    int bands; /* rows of each; 0: it is drawn whole */
    struct script_item *items;
    size_t item_count;
    int32_t *values; /* arguments of all items; colors as their bits */
    size_t value_count;
    size_t polygon_max;          /* vertices of the largest polygon */
    struct script_asset *assets; /* fonts, pictures, texts, meshes it names */
    size_t asset_count;
    char *caption; /* the comment that the script begins with, or "" */
};

/* Reads a script (sim/scenes/README.md). `format`, when not NULL, replaces that
 * of its canvas line. False, with a message on standard error that names file
 * and line, when it is not right; the script is then empty. */
bool script_load(struct script *script, const char *path,
                 const struct pel_format *format);

/* The same from a stream; `path` names it in messages, and its folder is that
 * of the script's files. */
bool script_read(struct script *script, FILE *file, const char *path,
                 const struct pel_format *format);

void script_free(struct script *script);

/* True when it moves pixels that have been drawn: it cannot be drawn in bands
 * or by several threads. */
bool script_needs_whole(const struct script *script);

/* Draws the script onto a canvas of its size and format, in bands of `rows`
 * rows (0: whole, -1: as script->bands). False, with a message and nothing
 * drawn, when bands are not possible; or when memory is short. */
bool script_draw(const struct script *script, struct canvas *canvas, int rows);

/* The index of the last item, seen by the script's clip, that draws pixel
 * (x, y) of its canvas: a shape, a text, a picture, a mesh; -1: none but
 * clear. -1, with a message, when memory is short. */
long script_pick(const struct script *script, int x, int y);

/* Prints what its commands do to pixel (x, y) of its canvas, and why; all:
 * those that leave it alone, too. False, with a message, when memory is short.
 */
bool script_explain(const struct script *script, int x, int y, bool all);

/* Finds a script with as few lines of `path` as it can that a command fails for
 * as it fails for the whole, and writes it to `output` ("-": standard output).
 * The command is one of sh; $1 is the script, in the folder of `path`, so that
 * it finds its files. It fails when its status is not 0: a script counts as
 * failing when the status is that of the whole. False, with a message. */
bool script_shrink(const char *path, const char *command, const char *output);

#endif
