#include "formats.h"

#define BITS 1
#define PAGES 0
#include "gray.inc"
#include "body_bits.inc"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    pel_fill_bits(spans, pixel ? 0xFFu : 0u);
}

const struct pel_format pel_mono1 = {
    .id = PEL_FORMAT_MONO1,
    .fill = fill,
    .blend = pel_blend_mono,
    FORMAT_BITS,
};
