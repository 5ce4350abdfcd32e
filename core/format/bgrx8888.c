#include "fields.h"
#include "formats.h"

#define ORDER PEL_LE32
static const struct pel_fields fields = {{8, 8}, {16, 8}, {24, 8}, 0xFF};
#include "fields.inc"
#include "body32.inc"

const struct pel_format pel_bgrx8888 = {
    FORMAT_32,
    .id = PEL_FORMAT_BGRX8888,
};
