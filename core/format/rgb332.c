#include "fields.h"
#include "formats.h"

#define ORDER(v) (v)
static const struct pel_fields fields = {{5, 3}, {2, 3}, {0, 2}, 0};
#include "fields.inc"

#define WORD pel_word8
#include "body_word.inc"

static const struct pel_dithering dithering = {pattern, {3, 3, 2}};

const struct pel_format pel_rgb332 = {
    FORMAT_WORD,    .id = PEL_FORMAT_RGB332, .fill = pel_fill8,
    .blend = blend, .dithering = &dithering,
};
