/* Numbers in text, exactly: no floating point on the way. */
#ifndef SIM_CLI_NUMBER_H
#define SIM_CLI_NUMBER_H

#include <stddef.h>
#include <stdint.h>

#include "core/base/color.h"

enum number_status {
    NUMBER_OK,
    NUMBER_MALFORMED, /* not [+-]DIGITS[.DIGITS], or text after it */
    NUMBER_RANGE      /* beyond the given range */
};

/* A decimal in pixels to sub-pixels, the nearest 1/256 whatever the number of
 * digits; halves go up, so that moving by whole pixels changes nothing. Range:
 * PEL_COORDINATE_MIN..PEL_COORDINATE_MAX, after rounding. */
enum number_status number_subpixels(const char *text, int32_t *value);

/* A decimal to the nearest integer multiple of 1/unit, 1 <= unit <= 65,536, in
 * min..max; |min|, |max| < 2^47. */
enum number_status number_decimal(const char *text, int64_t unit, int64_t min,
                                  int64_t max, int64_t *value);

/* A whole number in min..max; |min|, |max| < 2^47. */
enum number_status number_integer(const char *text, int64_t min, int64_t max,
                                  int64_t *value);

/* A color at the beginning of a text, #rrggbb (opaque) or #rrggbbaa: its
 * length, or 0. */
size_t number_color(const char *text, pel_color *color);

#endif
