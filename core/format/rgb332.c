#include "fields.h"
#include "formats.h"
#include "word8.h"

#define ORDER(v) (v)
static const struct pel_fields fields = {{5, 3}, {2, 3}, {0, 2}, 0};
#include "fields.inc"

#define WORD pel_word8
#include "body_word.inc"

const struct pel_format pel_rgb332 = {
    PEL_FORMAT_RGB332, 8, 1, pack, unpack, pel_fill8, blend, put, load,
};
