/* C text of arrays, in lines of at most 80 columns. */
#ifndef SIM_IMPORT_TEXT_H
#define SIM_IMPORT_TEXT_H

#include <stdint.h>

#include "output.h"

struct import_text {
    struct output output;
    int column; /* of the line that is being written */
};

/* Opens the file and writes its first lines: the comment, with the base name
 * of `source`, and #include `header`. */
bool import_text_open(struct import_text *text, const char *path,
                      const char *source, const char *header);

struct import_array {
    const char *type, *what;
    uint32_t count;
    int axes; /* numbers of an element */
};

/* `static const TYPE NAME_WHAT[COUNT][AXES] = {`, without AXES when it is 1. */
void import_array_begin(struct import_text *text, const char *name,
                        const struct import_array *array);

/* One element: a number when n is 1, else {a, b, ...}. */
void import_array_item(struct import_text *text, const long *value, int n);

void import_array_end(struct import_text *text);

#endif
