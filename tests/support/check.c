#include "check.h"

#include <stdio.h>
#include <stdlib.h>

enum { TESTS_MAX = 64 };

static struct test {
    test_function *function;
    int line;
} tests[TESTS_MAX];
static struct CMUnitTest units[TESTS_MAX];
static size_t count;

static void run(void **state)
{
    const struct test *test = *state;
    test->function();
}

/* Those of later lines move up. */
void add_test(const char *name, test_function *function, int line)
{
    size_t i = count++;
    if (count > TESTS_MAX)
        abort();
    for (; i > 0 && tests[i - 1].line > line; i--) {
        tests[i] = tests[i - 1];
        units[i].name = units[i - 1].name;
    }
    tests[i] = (struct test){function, line};
    units[i].name = name;
}

int run_all_tests(void)
{
    if (count == 0) {
        fputs("no TEST in this program\n", stderr);
        abort();
    }
    for (size_t i = 0; i < count; i++) {
        units[i].test_func = run;
        units[i].initial_state = &tests[i];
    }
    return _cmocka_run_group_tests("tests", units, count, NULL, NULL);
}
