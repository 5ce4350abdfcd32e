#include <string.h>

#include "sim/cli/arguments.h"

int choice_find(const char *names, const char *name)
{
    const size_t length = strlen(name);
    for (int i = 0; *names; i++) {
        const size_t n = strcspn(names, "|");
        if (n == length && memcmp(names, name, n) == 0)
            return i;
        names += n + (names[n] == '|');
    }
    return -1;
}
