#include "formats.h"

#define BITS 2
#define PAGES 0
#include "gray.inc"
#include "body_bits.inc"

const struct pel_format pel_gray2 = {
    .id = PEL_FORMAT_GRAY2,
    .fill = fill_bits,
    .blend = blend,
    FORMAT_BITS,
};
