/* cmocka and the headers that it wants before it, and a way to write tests. */
#ifndef TESTS_SUPPORT_CHECK_H
#define TESTS_SUPPORT_CHECK_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* The head of a test, which fails by cmocka's asserts. The support library's
 * main runs those of the program from top to bottom; a main of one's own that
 * sets something up returns run_all_tests(). */
#define TEST(name)                                                      \
    static void test_##name(void);                                      \
    __attribute__((constructor)) static void register_test_##name(void) \
    {                                                                   \
        add_test("test_" #name, test_##name, __LINE__);                 \
    }                                                                   \
    static void test_##name(void)

typedef void test_function(void);
void add_test(const char *name, test_function *function, int line);
int run_all_tests(void);

#endif
