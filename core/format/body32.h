/* The body of formats whose pixel is a word of 32 bits. */
#ifndef PEL_FORMAT_BODY32_H
#define PEL_FORMAT_BODY32_H

#include "blend32.h"

#define WORD pel_word32
#include "body_word.inc"

static void blend32(const struct pel_spans *spans, pel_color color)
{
#if PEL_VECTORS
    pel_blend32_rows(spans, color);
#else
    blend(spans, color);
#endif
}

#endif
