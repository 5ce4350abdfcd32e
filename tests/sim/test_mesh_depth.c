/* Depths: what is parsed, and the exact order of sums of three. */
#include "tests/support/check.h"

#include <string.h>

#include "sim/mesh/pel2d.h"

struct row {
    const char *text;
    const char *back; /* as it is formatted again; NULL when it is refused */
};

static const struct row rows[] = {
    {"0", "0"},
    {"-0", "0"},
    {"+12", "12"},
    {"007.500", "7.5"},
    {"-0.000000000000000000000000000000000001",
     "-0.000000000000000000000000000000000001"},
    {"0.0000000000000000000000000000000000010", /* one digit more, a zero */
     "0.000000000000000000000000000000000001"},
    {"0.0000000000000000000000000000000000011", NULL},
    {"999999999999999999.999999999999999999999999999999999999",
     "999999999999999999.999999999999999999999999999999999999"},
    {"1000000000000000000", NULL},
    {"0000000000000000000001", "1"},
    {"1e-5", "0.00001"},
    {"1.25E+2", "125"},
    {"-1.5e0", "-1.5"},
    {"1e17", "100000000000000000"},
    {"1e18", NULL},
    {"0e9999", "0"},
    {"1e-37", NULL},
    {"1e12345", NULL},
    {"", NULL},
    {"-", NULL},
    {".5", NULL},
    {"5.", NULL},
    {"1e", NULL},
    {"1e+", NULL},
    {"1e5.0", NULL},
    {"1.2.3", NULL},
    {"0x10", NULL},
    {"nan", NULL},
    {"inf", NULL},
    {"--1", NULL},
    {"1 ", NULL},
};

TEST(text)
{
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        struct mesh_depth depth;
        char text[MESH_DEPTH_TEXT];
        bool right = mesh_depth_parse(rows[i].text, &depth);
        if (right != (rows[i].back != NULL))
            fail_msg("row %zu, '%s': %s", i, rows[i].text,
                     right ? "taken" : "refused");
        if (!right)
            continue;
        mesh_depth_format(&depth, text);
        if (strcmp(text, rows[i].back) != 0)
            fail_msg("row %zu: %s, not %s", i, text, rows[i].back);
    }
}

struct sums {
    const char *a[3], *b[3];
    int order;
};

static const struct sums sums[] = {
    /* Equal as decimals, not as doubles. */
    {{"0.1", "0.2", "0.3"}, {"0.2", "0.2", "0.2"}, 0},
    {{"1e17", "0.000000000000000001", "-1e17"}, {"0", "0", "0"}, 1},
    {{"-0.5", "-0.5", "-0.5"}, {"-1", "-1", "0.5"}, 0},
    {{"-0.5", "-0.5", "-0.5"}, {"-1", "-0.5", "0"}, 0},
    {{"-0.7", "0", "0"}, {"-0.6", "0", "0"}, -1},
    {{"0.999999999999999999", "0.999999999999999999", "0.000000000000000002"},
     {"2", "0", "0"},
     0},
    {{"1", "1", "1e-36"}, {"1", "1", "0"}, 1},
    {{"999999999999999999", "999999999999999999", "999999999999999999"},
     {"999999999999999999", "999999999999999999", "999999999999999999.1"},
     -1},
};

static struct mesh_depth sum_of(const char *const text[3])
{
    struct mesh_depth d[3];
    for (int k = 0; k < 3; k++)
        assert_true(mesh_depth_parse(text[k], &d[k]));
    return mesh_depth_sum(&d[0], &d[1], &d[2]);
}

TEST(sums)
{
    for (size_t i = 0; i < sizeof(sums) / sizeof(sums[0]); i++) {
        struct mesh_depth a = sum_of(sums[i].a), b = sum_of(sums[i].b);
        int forth = mesh_depth_compare(&a, &b), back;
        back = mesh_depth_compare(&b, &a);
        forth = (forth > 0) - (forth < 0);
        back = (back > 0) - (back < 0);
        if (forth != sums[i].order || back != -sums[i].order)
            fail_msg("row %zu: %d and %d, not %d", i, forth, back,
                     sums[i].order);
    }
}
