/* The functions of a format: how colours enter and leave pixels.
 *
 * A body is no header like others: a format includes one after its own pack and
 * unpack, which are inlined here, and names its functions in its object. The
 * body of a size of pixels (body8.h to body_bits.h) says where a pixel lies
 * (`place`), and how it is read and written (`get`, `set`). */
#ifndef PEL_FORMAT_BODY_H
#define PEL_FORMAT_BODY_H

#include "word.h"

/* The rule of all formats for one pixel. */
static void over(place p, pel_color color)
{
    const uint32_t alpha = pel_alpha(color);
    if (alpha == 255)
        set(p, pack(color));
    else if (alpha != 0)
        set(p, pack(pel_mix(unpack(get(p)), color, alpha)));
}

#endif
