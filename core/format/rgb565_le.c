#include "formats.h"

#define ORDER PEL_LE16
#define FIELDS {11, 5}, {5, 6}, {0, 5}, 0
#include "fields.inc"
#include "body565.inc"

/* No channels: Gouraud has a loop of its own for it. */
const struct pel_format pel_rgb565_le = {
    .id = PEL_FORMAT_RGB565_LE,
    FORMAT_565,
};

const struct pel_format pel_rgb565_le_fill = {
    .id = PEL_FORMAT_RGB565_LE,
    FILL_565,
};
