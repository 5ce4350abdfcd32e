/* The C text of a picture. */
#ifndef SIM_ASSET_PICTURE_TEXT_H
#define SIM_ASSET_PICTURE_TEXT_H

#include "sim/asset/import.h"
#include "sim/asset/text.h"

/* The colors of a picture with a palette. */
struct picture_table {
    pel_color color[256];
    size_t count;
};

/* As --format takes it. */
const char *picture_format_name(const struct pel_format *format);

/* Writes the asset with the name of text->options, and the table if it has one.
 * *in_runs becomes what words and rows of its runs take in flash; NULL: it has
 * none. False, with a message, where colors are too many or memory is short. */
bool picture_write(struct import_text *text, const struct picture *picture,
                   const struct pel_format *format, struct picture_table *table,
                   size_t *in_runs);

#endif
