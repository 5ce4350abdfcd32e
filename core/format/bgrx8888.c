#include "fields.h"
#include "formats.h"

#define ORDER PEL_LE32
static const struct pel_fields fields = {{8, 8}, {16, 8}, {24, 8}, 0xFF};
#include "fields.inc"
#include "body32.h"

const struct pel_format pel_bgrx8888 = {
    PEL_FORMAT_BGRX8888, 32, 4, pack, unpack, pel_fill32, blend32, put, load,
};
