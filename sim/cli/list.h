/* Lists that grow by one entry at a time. */
#ifndef SIM_CLI_LIST_H
#define SIM_CLI_LIST_H

#include <stdlib.h>

#include "sim/cli/message.h"

/* A list of `count` entries of `size` bytes with room for one more: there is
 * room for a power of two. NULL, with a message, when memory is short: the list
 * is then as it was. */
static inline void *list_grow(void *list, size_t count, size_t size)
{
    if (count & (count - 1))
        return list;
    void *grown = realloc(list, (count ? 2 * count : 1) * size);
    if (!grown)
        message_error("out of memory");
    return grown;
}

#endif
