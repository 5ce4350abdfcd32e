#include <stdlib.h>

#include "sim/cli/child.h"
#include "sim/cli/message.h"

void child_put(FILE *out, const void *data, size_t size)
{
    fwrite(&size, sizeof(size), 1, out);
    if (size > 0)
        fwrite(data, 1, size, out);
}

void *child_get(FILE *in, size_t *size, bool *good)
{
    *size = 0;
    if (*good && fread(size, sizeof(*size), 1, in) != 1)
        *good = message_error("a child process ended its result too early");
    if (!*good || *size == 0)
        return NULL;
    void *data = malloc(*size);
    *good = (data && fread(data, 1, *size, in) == *size) ||
            message_error("no memory for %zu bytes", *size);
    return data;
}
