/* The kernel's keys, KEY_A and so on, as enum pel_key. */
#ifndef PEL_PORT_LINUX_EVDEV_KEYS_H
#define PEL_PORT_LINUX_EVDEV_KEYS_H

#include "../../drivers/input.h"

PEL_BEGIN_DECLS
uint16_t pel_evdev_key(int code);
PEL_END_DECLS

#endif
