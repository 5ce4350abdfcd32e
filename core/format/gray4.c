#include "formats.h"

#define BITS 4
#define PAGES 0
#include "gray.inc"
#include "body_bits.inc"

const struct pel_format pel_gray4 = {
    .id = PEL_FORMAT_GRAY4,
    .fill = fill_bits,
    .blend = blend,
    FORMAT_BITS,
};
