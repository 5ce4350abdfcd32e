/* C text of an asset: arrays, in lines of at most 80 columns, and a struct. */
#ifndef SIM_ASSET_TEXT_H
#define SIM_ASSET_TEXT_H

#include <stdint.h>

#include "sim/cli/output.h"

struct import_options;

struct import_text {
    struct output output;
    const struct import_options *options;
    const char *kind;   /* "image": struct pel_image_asset */
    const char *format; /* of a picture, "gray4": pel_gray4; else NULL */
    bool palette;       /* of a picture: struct pel_palette, NAME_palette */
    bool alpha;         /* of an image: another one, NAME_alpha */
    bool shading;       /* of a mesh: struct pel_shading *, NAME_shading */
    int scratch[2];     /* of an icon: sides in a row, 1,024ths of its width */
    unsigned mappings;  /* of its textures: NAME_mapping and NAME_span */
    int column;         /* of the line that is being written */
};

enum { IMPORT_NAME = 128 }; /* bytes of a name */

/* A name of C from the output's: its base name up to the first dot, with _ for
 * what C does not take. */
const char *import_name(const char *output, char name[IMPORT_NAME]);

/* True for an identifier of C that neither C nor C++ has already; false with a
 * message. */
bool import_name_check(const char *name);

/* Opens the output and writes its first lines: the comment, with the base name
 * of the source, and #include of the header of that kind of asset. */
bool import_text_open(struct import_text *text,
                      const struct import_options *options, const char *kind);

/* Ends the output and puts it in its place, and beside it, unless that is
 * standard output, its header: .h for .c. A header that pel import has not made
 * stays as it is, and a message says what it has to declare. */
bool import_text_commit(struct import_text *text);

/* `static const TYPE NAME_WHAT[COUNT][AXES] = {`, without AXES when it is 1;
 * elements; and the end. */
void import_array_begin(struct import_text *text, const char *type,
                        const char *what, uint32_t count, int axes);
__attribute__((format(printf, 2, 3))) void import_item(struct import_text *text,
                                                       const char *format, ...);
void import_array_end(struct import_text *text);

/* An array of numbers: all of them, of `type`; NULL data is left out. */
struct import_array {
    const char *type, *what;
    uint32_t count;
    int axes; /* numbers of an element, which is {a, b, ...} unless that is 1 */
    const void *data;
};
void import_array(struct import_text *text, const struct import_array *array);

/* `const struct pel_KIND_asset NAME = {`, and its declaration before it. */
void import_struct_begin(struct import_text *text);

#endif
