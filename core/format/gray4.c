#include "formats.h"

#define BITS 4
#include "gray.inc"
#include "body_bits.inc"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    pel_fill_bits(spans, pixel * 0x11u);
}

static const struct pel_dithering dithering = {pattern_bits, {4, 0, 0}};

const struct pel_format pel_gray4 = {
    .id = PEL_FORMAT_GRAY4,
    .bits = 4,
    .word = 1,
    .pack = pack,
    .unpack = unpack,
    .fill = fill,
    .blend = blend,
    .put = put,
    .load = load,
    .dithering = &dithering,
};
