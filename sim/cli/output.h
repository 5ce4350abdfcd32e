/* Output files that appear whole or not at all: written to memory first, then
 * to a temporary file in the same directory that takes the name. */
#ifndef SIM_CLI_OUTPUT_H
#define SIM_CLI_OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

struct output {
    FILE *stream;     /* write here */
    const char *path; /* the caller's; "-" is standard output */
    char *data;
    size_t size;
    char *target, *temporary; /* names, while it is written */
};

/* False, with a message on standard error, when memory is short. */
bool output_open(struct output *output, const char *path);

/* Ends the output and puts it in its place. Devices, pipes and links to nothing
 * are written to; links are followed; the mode of an existing file is kept.
 * False, with a message, when that failed: the old file is then untouched.
 * Signals that end the program come after it, so that nothing is left behind.
 */
bool output_commit(struct output *output);

/* The same for two, written whole before either appears; `second` may be NULL.
 */
bool output_commit_both(struct output *output, struct output *second);

/* Ends the output and writes nothing. */
void output_abandon(struct output *output);

#endif
