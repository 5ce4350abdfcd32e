#include "formats.h"

#define ORDER PEL_LE16
#define FIELDS {0, 5}, {5, 6}, {11, 5}, 0
#include "fields.inc"
#include "body565.inc"

const struct pel_format pel_bgr565_le = {
    .id = PEL_FORMAT_BGR565_LE,
    FORMAT_565,
    WHOLE_CHANNELS,
};
