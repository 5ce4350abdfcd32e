#include "formats.h"

#define ORDER PEL_LE32
#define FIELDS {24, 8}, {16, 8}, {8, 8}, 0xFF
#include "fields.inc"
#include "body32.inc"

const struct pel_format pel_rgbx8888 = {
    .id = PEL_FORMAT_RGBX8888,
    FORMAT_32,
};
