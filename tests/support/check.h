/* cmocka and the headers that it wants before it, and a way to run tests. */
#ifndef TESTS_SUPPORT_CHECK_H
#define TESTS_SUPPORT_CHECK_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Fails by cmocka's asserts. */
typedef void test_function(void);

/* Runs the functions and returns what main shall: `return RUN_TESTS(a, b);` */
#define RUN_TESTS(...)          \
    run_all_tests(#__VA_ARGS__, \
                  (test_function *const[]){__VA_ARGS__, (test_function *)0})
int run_all_tests(const char *names, test_function *const *functions);

#endif
