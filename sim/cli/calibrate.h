/* Touch screens that are out of place: pel input --calibrate. */
#ifndef SIM_CLI_CALIBRATE_H
#define SIM_CLI_CALIBRATE_H

#include "sim/cli/device.h"

/* Shows three crosses on the device, one after the other, waits until each is
 * touched, checks what follows by a fourth, and writes the matrix of
 * port/linux/touch_matrix.h into the file. False, with a message, when a key
 * ends it, or when the crosses were missed: then nothing is written. */
bool calibrate(const struct device_options *device, const char *path);

#endif
