#include "fields.h"
#include "formats.h"

#define ORDER PEL_LE16
static const struct pel_fields fields = {{11, 5}, {5, 6}, {0, 5}, 0};
#include "fields.inc"
#include "body565.inc"

const struct pel_format pel_rgb565_le = {
    FORMAT_565,
    .id = PEL_FORMAT_RGB565_LE,
};

const struct pel_format pel_rgb565_le_fill = {
    FILL_565,
    .id = PEL_FORMAT_RGB565_LE,
};
