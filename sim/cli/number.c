#include "sim/cli/number.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/point.h"

#define DIGITS "0123456789"

enum { PLACES = 13 };
static const int64_t scale = INT64_C(10000000000000); /* 10^PLACES */

/* floor(fraction unit + 1/2) of the digits behind a point, of which there are
 * n; halves go down for `negative`. The first 13 digits count, and whether one
 * after them is not 0: their product with unit <= 2^16 is below 2^60. */
static int64_t round_fraction(const char *digits, size_t n, int64_t unit,
                              bool negative)
{
    int64_t fraction = 0;
    for (size_t i = 0; i < PLACES; i++)
        fraction = fraction * 10 + (i < n ? digits[i] - '0' : 0);
    const bool more = n > PLACES && strspn(digits + PLACES, "0") < n - PLACES;
    const int64_t twice = 2 * (fraction * unit % scale);
    const bool up = twice == scale ? more || !negative : twice > scale;
    return fraction * unit / scale + up;
}

enum number_status number_decimal(const char *text, int64_t unit, int64_t min,
                                  int64_t max, int64_t *value)
{
    const int64_t limit = INT64_C(1) << 46; /* out of every range */
    const char *digits = text + (*text == '-' || *text == '+');
    const size_t n = strspn(digits, DIGITS);
    const char *point = digits + n;
    const size_t places = *point == '.' ? strspn(point + 1, DIGITS) : 0;
    if (n + places == 0 || point[places + (*point == '.')])
        return NUMBER_MALFORMED;
    const int64_t whole = strtoll(digits, NULL, 10); /* or the largest one */
    int64_t v = (whole < limit ? whole : limit) * unit +
                round_fraction(point + 1, places, unit, *text == '-');
    v = *text == '-' ? -v : v;
    if (v < min || v > max)
        return NUMBER_RANGE;
    *value = v;
    return NUMBER_OK;
}

enum number_status number_subpixels(const char *text, int32_t *value)
{
    int64_t v;
    const enum number_status status =
        number_decimal(text, 256, PEL_COORDINATE_MIN, PEL_COORDINATE_MAX, &v);
    if (status == NUMBER_OK)
        *value = (int32_t)v;
    return status;
}

enum number_status number_integer(const char *text, int64_t min, int64_t max,
                                  int64_t *value)
{
    return strchr(text, '.') ? NUMBER_MALFORMED
                             : number_decimal(text, 1, min, max, value);
}

size_t number_color(const char *text, pel_color *color)
{
    const size_t digits =
        *text == '#' ? strspn(text + 1, DIGITS "abcdefABCDEF") : 0;
    if (digits != 6 && digits != 8)
        return 0;
    const uint32_t v = (uint32_t)strtoul(text + 1, NULL, 16);
    *color = digits == 6 ? 0xFF000000u | v : v << 24 | v >> 8;
    return digits + 1;
}
