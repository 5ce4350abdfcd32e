#include "fields.h"
#include "formats.h"

#define ORDER(v) (v)
static const struct pel_fields fields = {{0, 8}, {8, 8}, {16, 8}, 0};
#include "fields.inc"
#include "body24.h"

const struct pel_format pel_bgr888 = {
    PEL_FORMAT_BGR888, 24, 1, pack, unpack, pel_fill24, blend, put, load,
};
