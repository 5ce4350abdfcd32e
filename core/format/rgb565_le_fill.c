#include "formats.h"
#include "rgb565.h"
#include "word16.h"

static uint32_t pack(pel_color c)
{
    return PEL_LE16(pel_rgb565(c));
}

const struct pel_format pel_rgb565_le_fill = {
    .id = PEL_FORMAT_RGB565_LE,
    .bits = 16,
    .word = 2,
    .pack = pack,
    .fill = pel_fill16,
};
