#include "check.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>

/* Of cases.c and of sanitizers, where they are linked. */
void cases_report(void) __attribute__((weak));
void __sanitizer_set_death_callback(void (*report)(void)) __attribute__((weak));

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

static int report(void **state)
{
    (void)state;
    if (cases_report)
        cases_report();
    return 0;
}

static void die(void)
{
    report(NULL);
}

static void die_of(int number)
{
    signal(number, SIG_DFL);
    report(NULL);
    raise(number);
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
    signal(SIGABRT, die_of);
    if (__sanitizer_set_death_callback)
        __sanitizer_set_death_callback(die);
    for (size_t i = 0; i < count; i++) {
        units[i].test_func = run;
        units[i].teardown_func = report;
        units[i].initial_state = &tests[i];
    }
    return _cmocka_run_group_tests("tests", units, count, NULL, NULL);
}
