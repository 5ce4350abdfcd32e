#include "formats.h"
#include "rgb565.h"
#include "word16.h"

static uint32_t pack(pel_color c)
{
    return PEL_BE16(pel_rgb565(c));
}

const struct pel_format pel_rgb565_be_fill = {
    .id = PEL_FORMAT_RGB565_BE,
    .bits = 16,
    .word = 2,
    .pack = pack,
    .fill = pel_fill16,
};
