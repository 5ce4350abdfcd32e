#include "formats.h"

#define BITS 1
#include "gray.inc"
#include "body_bits.h"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    pel_fill_bits(spans, pixel ? 0xFFu : 0u);
}

const struct pel_format pel_mono1 = {
    PEL_FORMAT_MONO1, 1, 1, pack, unpack, fill, pel_blend_mono, put, load,
};
