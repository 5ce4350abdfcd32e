#include "formats.h"

#define BITS 1
#define PAGES 0
#include "gray.inc"
#include "body_bits.inc"

const struct pel_format pel_mono1 = {
    .id = PEL_FORMAT_MONO1,
    .fill = fill_bits,
    .blend = pel_blend_mono,
    FORMAT_BITS,
};
