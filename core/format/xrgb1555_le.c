#include "fields.h"
#include "formats.h"

#define ORDER PEL_LE16
static const struct pel_fields fields = {{10, 5}, {5, 5}, {0, 5}, 0x8000};

#include "fields.inc"

#include "body16.h"

const struct pel_format pel_xrgb1555_le = {
    PEL_FORMAT_XRGB1555_LE, 16, 2, pack, unpack, pel_fill16, blend, put, load,
};
