/* The kernel's keys, KEY_A and so on, as enum pel_key. */
#ifndef PEL_PORT_LINUX_EVDEV_KEYS_H
#define PEL_PORT_LINUX_EVDEV_KEYS_H

#include <stdint.h>

uint16_t pel_evdev_key(int code);

#endif
