/* The list comes from the makefile, which knows what is installed:
 * BENCH_METHODS is X(method_a) X(method_b)..., BENCH_ABSENT a string. */
#include "method.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define X(name) extern const struct method name;
BENCH_METHODS
#undef X

#define X(name) &name,
const struct method *const methods[] = {BENCH_METHODS NULL};
#undef X

const char methods_absent[] = BENCH_ABSENT;

bool method_is_pel(const struct method *m)
{
    return strcmp(m->name, "pel") == 0;
}

bool method_is_limit(const struct method *m)
{
    return strcmp(m->name, "memset") == 0;
}

bool method_is_peer(const struct method *m)
{
    return !method_is_pel(m) && !method_is_limit(m);
}

bool method_is_apart(const struct method *m)
{
    return strcmp(m->name, "osmesa") == 0;
}

void *method_allocate(int n, size_t size)
{
    void *memory = calloc((size_t)n, size);
    if (!memory)
        method_fail("out of memory", "free some and start again");
    return memory;
}

void method_fail(const char *what, const char *right)
{
    fprintf(stderr, "pel: bench: %s; %s\n", what, right);
    exit(2);
}
