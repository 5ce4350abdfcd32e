#include "formats.h"

#define BITS 2
#define PAGES 0
#include "gray.inc"
#include "body_bits.inc"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    pel_fill_bits(spans, pixel * 0x55u);
}

const struct pel_format pel_gray2 = {
    .id = PEL_FORMAT_GRAY2,
    .fill = fill,
    .blend = blend,
    FORMAT_BITS,
};
