#include "formats.h"

#define BITS 4
#define PAGES 0
#include "gray.inc"
#include "body_bits.inc"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    pel_fill_bits(spans, pixel * 0x11u);
}

const struct pel_format pel_gray4 = {
    .id = PEL_FORMAT_GRAY4,
    .fill = fill,
    .blend = blend,
    FORMAT_BITS,
};
