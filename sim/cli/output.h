/* Output files that appear whole or not at all: written to a file without a
 * name in the same folder, which then takes the name. */
#ifndef SIM_CLI_OUTPUT_H
#define SIM_CLI_OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

struct output {
    FILE *stream;         /* write here */
    const char *path;     /* the caller's; "-" is standard output */
    char *target;         /* the file that path names, through links */
    char *temporary;      /* a name beside it, while it has one */
    bool has_place;       /* the stream's file lies beside the target */
    const char *in_place; /* why the target is to be written to; or NULL */
};

/* False, with a message on standard error, when there is no room anywhere. */
bool output_open(struct output *output, const char *path);

/* Ends the output and puts it in its place. Devices, pipes and links to nothing
 * are written to; links are followed. A file that was there passes on its
 * owner, group and mode, but for setuid and setgid; where its folder takes no
 * new file, or its owner cannot be passed on, it is written in place, with a
 * word. False, with a message, when that failed: the old file is then
 * untouched, unless it was written in place. Signals that end the program come
 * after it, so that nothing is left behind.
 */
bool output_commit(struct output *output);

/* The same for two, written whole before either appears; `second` may be NULL.
 */
bool output_commit_both(struct output *output, struct output *second);

/* Ends the output and writes nothing. */
void output_abandon(struct output *output);

#endif
