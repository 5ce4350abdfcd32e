#include "formats.h"

#define ORDER(v) (v)
#define FIELDS {5, 3}, {2, 3}, {0, 2}, 0
#include "fields.inc"

#define WORD pel_word8
#include "body_word.inc"

const struct pel_format pel_rgb332 = {
    .id = PEL_FORMAT_RGB332,
    .fill = pel_fill8,
    .blend = blend,
    .depth = {3, 3, 2},
    WHOLE_CHANNELS,
    FORMAT_WORD,
};
