#include "formats.h"

#define ORDER PEL_LE32
#define FIELDS {0, 8}, {8, 8}, {16, 8}, 0xFF000000
#include "fields.inc"
#include "body32.inc"

const struct pel_format pel_xbgr8888 = {
    .id = PEL_FORMAT_XBGR8888,
    FORMAT_32,
};
