#include "formats.h"

#define ORDER PEL_LE32
#define FIELDS {8, 8}, {16, 8}, {24, 8}, 0xFF
#include "fields.inc"
#include "body32.inc"

const struct pel_format pel_bgrx8888 = {
    .id = PEL_FORMAT_BGRX8888,
    FORMAT_32,
};
