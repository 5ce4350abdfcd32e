#include "check.h"

/* In a file of its own: a program that has a main does not link it. */
int main(void)
{
    return run_all_tests();
}
