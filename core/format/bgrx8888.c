#include "fields.h"
#include "formats.h"

#define ORDER PEL_LE32
static const struct pel_fields fields = {{8, 8}, {16, 8}, {24, 8}, 0xFF};
#include "fields.inc"
#include "body32.h"

const struct pel_format pel_bgrx8888 = {
    .id = PEL_FORMAT_BGRX8888,
    .bits = 32,
    .word = 4,
    .pack = pack,
    .unpack = unpack,
    .fill = pel_fill32,
    .blend = blend32,
    .put = put,
    .load = load,
};
