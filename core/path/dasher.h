/* The pen that cuts lines into dashes, before that of the stroke. */
#ifndef PEL_PATH_DASHER_H
#define PEL_PATH_DASHER_H

#include "stroker.h"

struct pel_dasher {
    struct pel_pen pen;
    struct pel_stroker stroker;       /* draws the dashes */
    int32_t period, start_left, left; /* 1/8192 px: of all dashes and gaps; what
                                         is left of the present one where a part
                                         begins, and here */
    int32_t start_index, index; /* of the present one; an even one is a dash */
    struct pel_point start, at;
    bool has_length; /* this part, up to here */
};

/* Begins a stroke, with dashes or without; *pen draws it. PEL_ERROR_RANGE: a
 * number of the stroke is out of range. */
enum pel_status pel_dasher_begin(struct pel_dasher *d,
                                 const struct pel_stroke *stroke,
                                 struct pel_sides *sides, struct pel_pen **pen);

#endif
