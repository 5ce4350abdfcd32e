/* Lists that grow by one entry at a time. */
#ifndef SIM_CLI_LIST_H
#define SIM_CLI_LIST_H

#include <stdlib.h>
#include <string.h>

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

/* Adds a copy of an entry of `size` bytes to the list at *list. */
static inline bool list_add(void *list, size_t *count, const void *entry,
                            size_t size)
{
    char *entries;
    memcpy(&entries, list, sizeof entries);
    entries = list_grow(entries, *count, size);
    if (!entries)
        return false;
    memcpy(entries + *count * size, entry, size);
    memcpy(list, &entries, sizeof entries);
    ++*count;
    return true;
}

#endif
