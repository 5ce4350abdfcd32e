#include "formats.h"

#define ORDER(v) (v)
#define FIELDS {0, 8}, {8, 8}, {16, 8}, 0
#include "fields.inc"
#include "body24.inc"

const struct pel_format pel_bgr888 = {
    .id = PEL_FORMAT_BGR888,
    FORMAT_24,
};
