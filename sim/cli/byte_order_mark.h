/* The UTF-8 byte order mark, which some editors write before a text. */
#ifndef SIM_CLI_BYTE_ORDER_MARK_H
#define SIM_CLI_BYTE_ORDER_MARK_H

#include <stddef.h>
#include <string.h>

/* Bytes of the mark that the text begins with: 3, or 0 where there is none. */
static inline size_t byte_order_mark(const char *text)
{
    return strncmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
}

#endif
