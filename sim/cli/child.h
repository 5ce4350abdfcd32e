/* Work that may crash, hang or take all memory, done in a child process:
 * libraries that read files are trusted with nothing else. */
#ifndef SIM_CLI_CHILD_H
#define SIM_CLI_CHILD_H

#include <stdbool.h>
#include <stdio.h>

/* Limits for reading one file; --limit of every command sets them. */
struct child_limits {
    int seconds;   /* of the clock on the wall */
    int megabytes; /* of memory, beside what pel has already */
};
extern struct child_limits child_limits;

/* A format for what takes more than a limit, which is its argument. */
#define CHILD_LIMIT_TEXT(unit)           \
    "reading it took more than %d " unit \
    ": expected less, or a higher --limit SECONDS,MEGABYTES"

/* Writes its result to `out`. False, with a message. */
typedef bool child_work(const void *what, FILE *out);

/* Does the work in a child process and returns its result, for the caller to
 * read and close. NULL, with a message that names the file at `path`, when the
 * work failed, crashed, or went beyond a limit. What libraries print is not
 * shown, but for the last line before a crash. */
FILE *child_run(const char *path, child_work *work, const void *what);

/* Sends a block of memory from the child: `size` bytes, 0 for NULL. */
void child_put(FILE *out, const void *data, size_t size);

/* The next block, malloc'ed, or NULL; *size is set. *good becomes false, with
 * a message, when memory is short or the result ends too early. */
void *child_get(FILE *in, size_t *size, bool *good);

#endif
