/* The assets that `pel import` writes. */
#ifndef SIM_ASSET_IMPORT_H
#define SIM_ASSET_IMPORT_H

#include "core/base/format.h"
#include "sim/mesh/mesh.h"
#include "sim/cli/arguments.h"
#include "sim/image/picture.h"

/* The name of the format that keeps the alpha of pictures; no display has it,
 * so that format_find knows nothing of it. */
#define IMPORT_ALPHA_FORMAT "argb8888"

struct import_options {
    const char *source;   /* file, for the comment: its base name is shown */
    const char *output;   /* file or "-" */
    const char *name;     /* of the C object */
    int normal_bits;      /* 8 or 16 */
    const char *codes;    /* of a font: code points to keep, or NULL for all */
    pel_color background; /* of a picture's transparent parts, opaque */
};

/* Write a C file with one const struct and its arrays, and its header beside
 * it, the same for the same input: no date, no path. False, with a message on
 * standard error, when that failed. */
bool import_mesh(const struct import_options *options, const struct mesh *mesh);
bool import_font(const struct import_options *options);

/* The picture is made opaque, with a note on standard error when it was not,
 * unless the format is pel_argb8888. */
bool import_picture(const struct import_options *options,
                    struct picture *picture, const struct pel_format *format);

/* What is made, in the bits of a set. */
enum import_kind {
    IMPORT_MESH = 1,
    IMPORT_PICTURE = 2,
    IMPORT_FONT = 4,
    IMPORT_PEL2D = 8
};

/* Does every option that was given mean something for this kind? False, with a
 * message that says what the first one that does not is for. */
bool import_check(const struct options_given *given, enum import_kind kind);

/* Are these code points as --codes wants them? False, with a message. */
bool import_codes_legal(const char *codes);

#endif
