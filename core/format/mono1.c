#include "formats.h"

#define BITS 1
#include "gray.inc"
#include "body_bits.inc"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    pel_fill_bits(spans, pixel ? 0xFFu : 0u);
}

static const struct pel_dithering dithering = {pattern_bits, {1, 0, 0}};

const struct pel_format pel_mono1 = {
    .id = PEL_FORMAT_MONO1,
    .bits = 1,
    .word = 1,
    .pack = pack,
    .unpack = unpack,
    .fill = fill,
    .blend = pel_blend_mono,
    .put = put,
    .load = load,
    .dithering = &dithering,
};
