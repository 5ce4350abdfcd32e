#include "fields.h"
#include "formats.h"

#define ORDER(v) (v)
static const struct pel_fields fields = {{16, 8}, {8, 8}, {0, 8}, 0};
#include "fields.inc"
#include "body24.inc"

const struct pel_format pel_rgb888 = {
    .id = PEL_FORMAT_RGB888,
    .bits = 24,
    .word = 1,
    .pack = pack,
    .unpack = unpack,
    .fill = pel_fill24,
    .blend = blend,
    .put = put,
    .load = load,
};
