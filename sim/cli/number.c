#include "sim/cli/number.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/point.h"

/* A decimal as read: whole + fraction / scale, and the sign. Whole parts stop
 * at 2^48: that is out of every range. The fraction keeps 13 digits; `rest`
 * says whether any digit after them is not 0. */
struct decimal {
    bool negative, rest;
    int64_t whole, fraction, scale;
};

enum { FRACTION_DIGITS = 13 };

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static const char *read_whole(const char *s, int64_t *whole)
{
    const int64_t limit = INT64_C(1) << 48;
    for (*whole = 0; is_digit(*s); s++) {
        *whole = *whole * 10 + (*s - '0');
        if (*whole > limit)
            *whole = limit;
    }
    return s;
}

static const char *read_fraction(const char *s, struct decimal *d)
{
    for (int n = 0; is_digit(*s); s++, n++) {
        if (n < FRACTION_DIGITS) {
            d->fraction = d->fraction * 10 + (*s - '0');
            d->scale *= 10;
        } else if (*s != '0') {
            d->rest = true;
        }
    }
    return s;
}

static bool read_decimal(const char *s, struct decimal *d)
{
    const struct decimal zero = {false, false, 0, 0, 1};
    *d = zero;
    d->negative = *s == '-';
    if (*s == '-' || *s == '+')
        s++;
    const char *start = s;
    s = read_whole(s, &d->whole);
    bool digits = s > start;
    if (*s == '.') {
        start = ++s;
        s = read_fraction(s, d);
        digits = digits || s > start;
    }
    return digits && *s == '\0';
}

/* floor(v unit + 1/2). fraction < 10^13 and unit <= 2^16, so their product is
 * below 2^60; whole <= 2^48, but whole unit must not exceed 2^62. */
static int64_t scale_decimal(const struct decimal *d, int64_t unit)
{
    const int64_t product = d->fraction * unit;
    const int64_t twice = 2 * (product % d->scale);
    const bool half = twice == d->scale && !d->rest;
    int64_t v = product / d->scale;
    if (half ? !d->negative : twice >= d->scale)
        v++;
    v += (d->whole < INT64_C(1) << 46 ? d->whole : INT64_C(1) << 46) * unit;
    return d->negative ? -v : v;
}

enum number_status number_decimal(const char *text, int64_t unit, int64_t min,
                                  int64_t max, int64_t *value)
{
    struct decimal d;
    if (!read_decimal(text, &d))
        return NUMBER_MALFORMED;
    const int64_t v = scale_decimal(&d, unit);
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
    struct decimal d;
    if (!read_decimal(text, &d) || d.scale != 1 || d.rest)
        return NUMBER_MALFORMED;
    return number_decimal(text, 1, min, max, value);
}

size_t number_color(const char *text, pel_color *color)
{
    const size_t digits =
        *text == '#' ? strspn(text + 1, "0123456789abcdefABCDEF") : 0;
    if (digits != 6 && digits != 8)
        return 0;
    const uint32_t v = (uint32_t)strtoul(text + 1, NULL, 16);
    *color = digits == 6 ? 0xFF000000u | v : v << 24 | v >> 8;
    return digits + 1;
}
