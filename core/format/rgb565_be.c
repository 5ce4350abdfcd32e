#include "fields.h"
#include "formats.h"

#define ORDER PEL_BE16
static const struct pel_fields fields = {{11, 5}, {5, 6}, {0, 5}, 0};
#include "fields.inc"
#include "body565.inc"

static const struct pel_dithering dithering = {NULL, {5, 6, 5}};

const struct pel_format pel_rgb565_be = {
    .id = PEL_FORMAT_RGB565_BE,
    .bits = 16,
    .word = 2,
    .pack = pack,
    .unpack = unpack,
    .fill = pel_fill16,
    .blend = blend565,
    .put = put565,
    .load = load,
    .dithering = &dithering,
};
