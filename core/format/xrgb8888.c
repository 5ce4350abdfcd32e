#include "formats.h"

#define ORDER PEL_LE32
#define FIELDS {16, 8}, {8, 8}, {0, 8}, 0xFF000000
#include "fields.inc"
#define PUT (PEL_VECTORS ? pel_put32 : put)
#include "body32.inc"

const struct pel_format pel_xrgb8888 = {
    .id = PEL_FORMAT_XRGB8888,
    FORMAT_32,
};
