#include "fields.h"
#include "formats.h"

#define ORDER PEL_LE16
static const struct pel_fields fields = {{11, 5}, {5, 6}, {0, 5}, 0};
#include "fields.inc"
#include "body565.h"

const struct pel_format pel_rgb565_le = {
    PEL_FORMAT_RGB565_LE, 16,       2,      pack, unpack,
    pel_fill16,           blend565, put565, load,
};
