#include "fields.h"
#include "formats.h"

#define ORDER(v) (v)
static const struct pel_fields fields = {{16, 8}, {8, 8}, {0, 8}, 0};
#include "fields.inc"
#include "body24.inc"

const struct pel_format pel_rgb888 = {
    FORMAT_24,
    .id = PEL_FORMAT_RGB888,
};
