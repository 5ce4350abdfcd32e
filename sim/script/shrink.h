/* Scripts cut down to what still shows a failure. */
#ifndef SIM_SCRIPT_SHRINK_H
#define SIM_SCRIPT_SHRINK_H

#include <stdbool.h>

/* Finds a script with as few lines of `path` as it can that a command fails for
 * as it fails for the whole, and writes it to `output` ("-": standard output).
 * The command is one of sh; $1 is the script, in the folder of `path`, so that
 * it finds its files. It fails when its status is not 0: a script counts as
 * failing when the status is that of the whole. False, with a message. */
bool script_shrink(const char *path, const char *command, const char *output);

#endif
