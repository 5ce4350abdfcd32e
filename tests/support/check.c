#include "check.h"

#include <string.h>

enum { TESTS_MAX = 64, NAME_SIZE = 80 };

static void run(void **state)
{
    test_function *const *function = *state;
    (*function)();
}

int run_all_tests(const char *names, test_function *const *functions)
{
    static char name[TESTS_MAX][NAME_SIZE];
    static struct CMUnitTest tests[TESTS_MAX];
    size_t n = 0;
    for (; functions[n]; n++) {
        const size_t length = strcspn(names, ",");
        if (n == TESTS_MAX || length >= NAME_SIZE)
            return 1;
        memcpy(name[n], names, length);
        tests[n].name = name[n];
        tests[n].test_func = run;
        tests[n].initial_state = (void *)(uintptr_t)&functions[n];
        names += length + strspn(names + length, ", ");
    }
    return _cmocka_run_group_tests("tests", tests, n, NULL, NULL);
}
