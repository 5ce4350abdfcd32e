#include "formats.h"
#include "word8.h"

#define BITS 8
#include "gray.inc"

#define WORD pel_word8
#include "body_word.inc"

const struct pel_format pel_gray8 = {
    PEL_FORMAT_GRAY8, 8, 1, pack, unpack, pel_fill8, blend, put, load,
};
