#include "formats.h"

#define ORDER PEL_LE16
#define FIELDS {10, 5}, {5, 5}, {0, 5}, 0x8000
#include "fields.inc"

#define WORD pel_word16
#include "body_word.inc"

const struct pel_format pel_xrgb1555_le = {
    .id = PEL_FORMAT_XRGB1555_LE,
    .fill = pel_fill16,
    .blend = blend,
    .depth = {5, 5, 5},
    WHOLE_CHANNELS,
    FORMAT_WORD,
};
