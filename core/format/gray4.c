#include "formats.h"

#define BITS 4
#include "gray.inc"
#include "body_bits.h"

static void fill(const struct pel_spans *spans, uint32_t pixel)
{
    pel_fill_bits(spans, pixel * 0x11u);
}

const struct pel_format pel_gray4 = {
    PEL_FORMAT_GRAY4, 4, 1, pack, unpack, fill, blend, put, load,
};
