#include "formats.h"
#include "word.h"

#define BITS 8
#include "gray.inc"

#define WORD pel_word8
#include "body_word.inc"

const struct pel_format pel_gray8 = {
    .id = PEL_FORMAT_GRAY8,
    .bits = 8,
    .word = 1,
    .pack = pack,
    .unpack = unpack,
    .fill = pel_fill8,
    .blend = blend,
    .put = put,
    .load = load,
};
