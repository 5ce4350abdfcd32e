#include "fields.h"
#include "formats.h"

#define ORDER(v) (v)
static const struct pel_fields fields = {{16, 8}, {8, 8}, {0, 8}, 0};
#include "fields.inc"
#include "body24.h"

const struct pel_format pel_rgb888 = {
    PEL_FORMAT_RGB888, 24, 1, pack, unpack, pel_fill24, blend, put, load,
};
