#include "formats.h"

#define ORDER(v) (v)
#define FIELDS {16, 8}, {8, 8}, {0, 8}, 0
#include "fields.inc"
#include "body24.inc"

const struct pel_format pel_rgb888 = {
    .id = PEL_FORMAT_RGB888,
    FORMAT_24,
};
