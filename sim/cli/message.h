/* Errors: a line on standard error, "what is wrong: expected what"; a long list
 * goes on in indented lines. All are false, so that a caller can
 * `return message_error(...)`. */
#ifndef SIM_CLI_MESSAGE_H
#define SIM_CLI_MESSAGE_H

#include <stdbool.h>
#include <stddef.h>

/* pel: FILE:LINE: TEXT; the line is left out when 0, the file when NULL. "-" is
 * shown as (standard input). */
__attribute__((format(printf, 3, 4))) bool message_error_at(const char *file,
                                                            long line,
                                                            const char *format,
                                                            ...);

/* pel: TEXT */
#define message_error(...) message_error_at(NULL, 0, __VA_ARGS__)

/* Where `at` points to what has the members path and line. */
#define ERROR_AT(at, ...) message_error_at((at)->path, (at)->line, __VA_ARGS__)

/* Until it is called with NULL, all errors name that place first, pel:
 * FILE:LINE: ...: for work that a script starts in functions without a line
 * number. */
void message_place(const char *file, long line);

#endif
