/* The body of the formats of 5-6-5 bits. */
#ifndef PEL_FORMAT_BODY565_H
#define PEL_FORMAT_BODY565_H

#include "blend565.h"
#include "body16.h"

static void blend565(const struct pel_rows *rows, pel_color color)
{
#if PEL_VECTORS
    pel_blend565_rows(rows, color);
#else
    blend(rows, color);
#endif
}

#endif
