/* Messages of Linux drivers: one line without a newline, for the program
 * to print. */
#ifndef PEL_DRIVERS_LINUX_MESSAGE_H
#define PEL_DRIVERS_LINUX_MESSAGE_H

#include <stdarg.h>
#include <stddef.h>

#include <pel/pel.h>

PEL_BEGIN_DECLS

struct pel_message {
    char text[480]; /* "" when there is nothing to say; cut when too long */
};

/* These return the errno. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
int pel_message_set(struct pel_message *message, int error, const char *format,
                    ...);

/* "WHAT: Permission denied" and so on, as errno says. */
int pel_message_errno(struct pel_message *message, const char *what);

/* Why `path` could not be opened, and what would help: for EACCES the group
 * that owns it and the usermod line, for a device that is not there `missing`.
 */
int pel_message_open(struct pel_message *message, const char *path, int error,
                     const char *missing);
PEL_END_DECLS
#endif
