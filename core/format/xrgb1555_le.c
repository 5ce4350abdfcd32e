#include "fields.h"
#include "formats.h"
#include "word16.h"

#define ORDER PEL_LE16
static const struct pel_fields fields = {{10, 5}, {5, 5}, {0, 5}, 0x8000};
#include "fields.inc"

#define WORD pel_word16
#include "body_word.inc"

const struct pel_format pel_xrgb1555_le = {
    PEL_FORMAT_XRGB1555_LE, 16, 2, pack, unpack, pel_fill16, blend, put, load,
};
