#include "formats.h"

#define BITS 8
#include "gray.inc"

#include "body8.h"

const struct pel_format pel_gray8 = {
    PEL_FORMAT_GRAY8, 8, 1, pack, unpack, pel_fill8, blend, put, load,
};
