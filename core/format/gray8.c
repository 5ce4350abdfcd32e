#include "formats.h"

#define BITS 8
#include "gray.inc"

#define WORD pel_word8
#include "body_word.inc"

const struct pel_format pel_gray8 = {
    .id = PEL_FORMAT_GRAY8,
    .fill = pel_fill8,
    .blend = blend,
    WHOLE_CHANNELS,
    FORMAT_WORD,
};
