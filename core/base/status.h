/* The result of functions that can fail: those that set something up or take
 * scratch memory. They check their pointers; other draw calls and hit tests do
 * not. A shape that is clipped away is no error. */
#ifndef PEL_BASE_STATUS_H
#define PEL_BASE_STATUS_H

#include "inline.h"

PEL_BEGIN_DECLS

enum pel_status {
    PEL_OK = 0,
    PEL_ERROR_NULL = -1,      /* a pointer that is needed is NULL */
    PEL_ERROR_SIZE = -2,      /* a size or a count out of range */
    PEL_ERROR_STRIDE = -3,    /* rows would overlap */
    PEL_ERROR_ALIGNMENT = -4, /* memory or stride no multiple of a pixel word */
    PEL_ERROR_SCRATCH = -5,   /* scratch memory too small or not aligned */
    PEL_ERROR_RANGE = -6,     /* a number out of its stated range */
    PEL_ERROR_FORMAT = -7,    /* not a format that can be read or drawn */
    PEL_ERROR_DEVICE = -16    /* a display: its driver has said what and why */
};

/* "PEL_ERROR_RANGE" and so on, for messages; "PEL_ERROR" for any other number.
 * A program that does not call it has none of the texts. */
const char *pel_status_name(enum pel_status status);

PEL_END_DECLS

#endif
