#include "formats.h"

#define ORDER PEL_BE16
#define FIELDS {11, 5}, {5, 6}, {0, 5}, 0
#include "fields.inc"
#include "body565.inc"

const struct pel_format pel_rgb565_be = {
    .id = PEL_FORMAT_RGB565_BE,
    FORMAT_565,
    WHOLE_CHANNELS,
};

const struct pel_format pel_rgb565_be_fill = {
    .id = PEL_FORMAT_RGB565_BE,
    FILL_565,
};
