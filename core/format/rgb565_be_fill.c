#include "fields.h"
#include "formats.h"
#include "word.h"

static const struct pel_fields fields = {{11, 5}, {5, 6}, {0, 5}, 0};

static uint32_t pack(pel_color c)
{
    return PEL_BE16(pel_fields_pack(&fields, c));
}

const struct pel_format pel_rgb565_be_fill = {
    .id = PEL_FORMAT_RGB565_BE,
    .bits = 16,
    .word = 2,
    .pack = pack,
    .fill = pel_fill16,
};
