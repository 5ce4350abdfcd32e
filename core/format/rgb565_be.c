#include "fields.h"
#include "formats.h"

#define ORDER PEL_BE16
static const struct pel_fields fields = {{11, 5}, {5, 6}, {0, 5}, 0};
#include "fields.inc"
#include "body565.inc"

const struct pel_format pel_rgb565_be = {
    FORMAT_565,
    .id = PEL_FORMAT_RGB565_BE,
};

const struct pel_format pel_rgb565_be_fill = {
    FILL_565,
    .id = PEL_FORMAT_RGB565_BE,
};
