/* Matrices of touch screens: three places that were touched undo any glass that
 * is turned, mirrored, skewed or out of place; what a file or a word says. */
#include "tests/support/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "port/linux/touch_matrix.h"
#include "tests/support/cases.h"

static double between(struct random *r, double low, double high)
{
    return low + (high - low) * random_between(r, 0, 1000000) / 1e6;
}

static struct pel_touch_matrix random_glass(struct random *r)
{
    struct pel_touch_matrix m = {
        .a = between(r, .5, 1.2) * (random_word(r) % 2 ? 1 : -1),
        .b = between(r, -.1, .1),
        .c = between(r, -.3, .3),
        .d = between(r, -.1, .1),
        .e = between(r, .5, 1.2) * (random_word(r) % 2 ? 1 : -1),
        .f = between(r, -.3, .3)};
    if (random_word(r) % 2)
        m = (struct pel_touch_matrix){m.b, m.a, m.c, m.e, m.d, m.f};
    return m;
}

TEST(three_places_undo_any_glass)
{
    static const struct pel_touch_place shown[3] = {
        {.12, .12}, {.88, .5}, {.5, .88}};
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *const r = &c.random;
        const struct pel_touch_matrix glass = random_glass(r);
        const struct pel_touch_place at = {between(r, 0, 1), between(r, 0, 1)};
        struct pel_touch_place told[3];
        struct pel_touch_matrix m;
        for (int i = 0; i < 3; i++)
            told[i] = pel_touch_matrix_place(&glass, shown[i]);
        assert_true(pel_touch_matrix_solve(&m, told, shown));
        const struct pel_touch_place back =
            pel_touch_matrix_place(&m, pel_touch_matrix_place(&glass, at));
        if (!(fabs(back.x - at.x) < 1e-9 && fabs(back.y - at.y) < 1e-9))
            fail_msg("%.9f, %.9f became %.9f, %.9f; %s", at.x, at.y, back.x,
                     back.y, cases_replay());
    }
}

TEST(places_that_say_nothing)
{
    static const struct pel_touch_place shown[3] = {
        {.1, .1}, {.9, .5}, {.5, .9}};
    static const struct pel_touch_place wrong[][3] = {
        {{.5, .5}, {.5, .5}, {.5, .5}}, {{.1, .1}, {.5, .5}, {.9, .9}},
        {{.1, .1}, {.1, .1}, {.5, .9}}, {{.1, .1}, {.2, .1}, {.1, .2}},
        {{0, 0}, {9, 0}, {0, 9}},       {{.1, .1}, {NAN, .5}, {.5, .9}}};
    struct pel_touch_matrix m;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        if (pel_touch_matrix_solve(&m, wrong[i], shown))
            fail_msg("places %zu were taken", i);
    assert_true(pel_touch_matrix_solve(&m, shown, shown));
}

TEST(words)
{
    static const struct {
        const char *text;
        struct pel_touch_matrix is;
    } right[] = {{"", PEL_TOUCH_SAME},
                 {"swap", {0, 1, 0, 1, 0, 0}},
                 {"swap,swap", PEL_TOUCH_SAME},
                 {"invert-x,swap", {0, 1, 0, -1, 0, 1}},
                 {"rotate=90,rotate=90", {-1, 0, 1, 0, -1, 1}},
                 {"range=0.5:1:0:0.5", {2, 0, -1, 0, 2, 0}}};
    static const char *const wrong[] = {"swop",
                                        "rotate=45",
                                        "range=1:1:0:1",
                                        "range=1:0:0:1",
                                        "range=0",
                                        "range=0:1:0:nan",
                                        "range=0:1:0:1:2",
                                        "/nothing",
                                        "swap ",
                                        ",,"};
    struct pel_touch_matrix m;
    struct pel_message message;
    for (size_t i = 0; i < sizeof right / sizeof *right; i++) {
        assert_int_equal(pel_touch_matrix_parse(&m, right[i].text, &message),
                         0);
        const struct pel_touch_matrix *const is = &right[i].is;
        if (m.a != is->a || m.b != is->b || m.c != is->c || m.d != is->d ||
            m.e != is->e || m.f != is->f)
            fail_msg("%s: %g %g %g %g %g %g", right[i].text, m.a, m.b, m.c, m.d,
                     m.e, m.f);
    }
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        if (pel_touch_matrix_parse(&m, wrong[i], &message) == 0)
            fail_msg("'%s' was taken", wrong[i]);
}

TEST(files)
{
    static const struct {
        const char *text;
        bool right;
    } rows[] = {
        {"0 1 0 1 0 0\n", true},
        {"# a remark\nLIBINPUT_CALIBRATION_MATRIX=\"0 1 0 1 0 0\"\n", true},
        {"1 0 0 0 1 0\nENV{LIBINPUT_CALIBRATION_MATRIX}=\"0 1 0 1 0 0\"", true},
        {"0 1 0 1 0 0 # by hand, x = y\n", true},
        {" \t# x=0 1 0 1 0 0\n", false},
        {"ATTRS{name}==\"glass #1\", ENV{X}=\"0 1 0 1 0 0\" # mine\n", true},
        {"%600d=0 1 0 1 0 0\n", true},
        {"%505d 0 1 0 1 0 0\n", false}, /* whose end alone is a matrix */
        {"", false},
        {"0 1 0 1 0\n", false},
        {"0 1 0 1 0 0 7\n", false},
        {"# 0 1 0 1 0 0\n", false},
        {"0 1 0 1 0 1e9\n", false},
        {"0 1 0 1 0 nan\n", false}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char path[] = "/tmp/pel-touch-XXXXXX";
        struct pel_touch_matrix m;
        struct pel_message message;
        const int fd = mkstemp(path);
        char text[700];
        const char *const digits = strchr(rows[i].text, '%');
        if (digits)
            snprintf(text, sizeof text, "%0*d%s", atoi(digits + 1), 0,
                     strchr(digits, 'd') + 1);
        else
            snprintf(text, sizeof text, "%s", rows[i].text);
        const size_t size = strlen(text);
        assert_int_equal(write(fd, text, size), size);
        close(fd);
        const int error = pel_touch_matrix_parse(&m, path, &message);
        unlink(path);
        if ((error == 0) != rows[i].right ||
            (!error && (m.b != 1 || m.d != 1 || m.a != 0)))
            fail_msg("file %zu: %d, %s", i, error, message.text);
    }
}
