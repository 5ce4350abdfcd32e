/* Names of keys, for options and messages: a character is its own name, but for
 * those in the table. */
#ifndef PEL_PORT_LINUX_KEY_NAMES_H
#define PEL_PORT_LINUX_KEY_NAMES_H

#include "../../drivers/input.h"

PEL_BEGIN_DECLS

enum { PEL_KEY_NAME_SIZE = 12 };

/* The key's code, or -1. */
int pel_key_find(const char *name);

/* "left", "f1", "a", or "key 240" for others. */
const char *pel_key_name(int code, char name[PEL_KEY_NAME_SIZE]);

PEL_END_DECLS
#endif
