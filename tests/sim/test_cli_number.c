/* Decimals in text against exact 128-bit arithmetic. */
#include <stdio.h>
#include <stdlib.h>

#include "tests/support/cases.h"
#include "tests/support/check.h"

#include "sim/cli/number.h"

struct row {
    const char *text;
    enum number_status status;
    int32_t value;
};

static const struct row rows[] = {
    {"0", NUMBER_OK, 0},
    {"-0", NUMBER_OK, 0},
    {"+1.5", NUMBER_OK, 384},
    {".5", NUMBER_OK, 128},
    {"7.", NUMBER_OK, 1792},
    {"-3.25", NUMBER_OK, -832},
    {"0.00390625", NUMBER_OK, 1},
    /* Halves go up; a digit far behind decides. */
    {"0.001953125", NUMBER_OK, 1},
    {"0.00195312499999999999999", NUMBER_OK, 0},
    {"-0.001953125", NUMBER_OK, 0},
    {"-0.001953125000000000000001", NUMBER_OK, -1},
    {"-0.005859375", NUMBER_OK, -1},
    /* The ends of the range, after rounding. */
    {"-32768", NUMBER_OK, -8388608},
    {"-32768.001953125", NUMBER_OK, -8388608},
    {"-32768.002", NUMBER_RANGE, 0},
    {"32767.99609375", NUMBER_OK, 8388607},
    {"32767.998", NUMBER_OK, 8388607},
    {"32767.998046875", NUMBER_RANGE, 0},
    {"32768", NUMBER_RANGE, 0},
    {"99999999999999999999999999", NUMBER_RANGE, 0},
    {"-99999999999999999999999999.5", NUMBER_RANGE, 0},
    {"18446744073709551616", NUMBER_RANGE, 0},
    {"000000000000000000000000012", NUMBER_OK, 3072},
    {"", NUMBER_MALFORMED, 0},
    {".", NUMBER_MALFORMED, 0},
    {"-", NUMBER_MALFORMED, 0},
    {"+-1", NUMBER_MALFORMED, 0},
    {"1e3", NUMBER_MALFORMED, 0},
    {"0x10", NUMBER_MALFORMED, 0},
    {"1,5", NUMBER_MALFORMED, 0},
    {"1.5px", NUMBER_MALFORMED, 0},
    {" 1", NUMBER_MALFORMED, 0},
    {"nan", NUMBER_MALFORMED, 0},
    {"inf", NUMBER_MALFORMED, 0},
};

TEST(table)
{
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        int32_t value = 12345;
        const enum number_status status =
            number_subpixels(rows[i].text, &value);
        if (status != rows[i].status ||
            (status == NUMBER_OK && value != rows[i].value))
            fail_msg("row %zu, \"%s\": status %d, value %d", i, rows[i].text,
                     (int)status, (int)value);
    }
}

/* floor(n unit / 10^digits + 1/2). */
static int64_t reference(int64_t n, int digits, int64_t unit)
{
    __extension__ __int128 numerator = n, denominator = 1;
    for (; digits > 0; digits--)
        denominator *= 10;
    numerator = 2 * numerator * unit + denominator;
    denominator *= 2;
    __extension__ __int128 q = numerator / denominator;
    if (numerator % denominator < 0)
        q--;
    return (int64_t)q;
}

TEST(random)
{
    struct random r = {1};
    for (int i = 0; i < 200000; i++) {
        char text[40];
        const int digits = 1 + (int)(random_word(&r) % 6);
        const int64_t unit = random_word(&r) % 2 ? 256 : 65536;
        const int64_t n = (int64_t)(random_word(&r) % 20000000) - 10000000;
        int64_t scale = 1, value, want = reference(n, digits, unit);
        for (int k = 0; k < digits; k++)
            scale *= 10;
        snprintf(text, sizeof text, "%s%lld.%0*lld", n < 0 ? "-" : "",
                 (long long)(llabs(n) / scale), digits,
                 (long long)(llabs(n) % scale));
        if (number_decimal(text, unit, INT32_MIN, INT64_C(1) << 46, &value) !=
                NUMBER_OK ||
            value != want)
            if (want >= INT32_MIN)
                fail_msg("%s at 1/%d: %lld, not %lld", text, (int)unit,
                         (long long)value, (long long)want);
    }
}

TEST(integer)
{
    int64_t value;
    assert_int_equal(number_integer("-5", -5, 5, &value), NUMBER_OK);
    assert_int_equal(value, -5);
    assert_int_equal(number_integer("6", -5, 5, &value), NUMBER_RANGE);
    assert_int_equal(number_integer("-6", -5, 5, &value), NUMBER_RANGE);
    assert_int_equal(number_integer("4.5", -5, 5, &value), NUMBER_MALFORMED);
    assert_int_equal(number_integer("4.0", -5, 5, &value), NUMBER_MALFORMED);
    assert_int_equal(number_integer("", -5, 5, &value), NUMBER_MALFORMED);
}
