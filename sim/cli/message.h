/* Errors: a line on standard error, "what is wrong: expected what". All are
 * false, so that a caller can `return message_error(...)`.
 *
 * A line has 500 bytes at most, and no character that a terminal obeys or that
 * nobody sees: of a longer one the middle is left out, and of the others ? is
 * shown. So files, their names and the words of libraries may be a part of it,
 * and go to people by no other way than the functions of this page. */
#ifndef SIM_CLI_MESSAGE_H
#define SIM_CLI_MESSAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

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

/* Prints a line, or a part of one, to anywhere; the caller ends the line. */
__attribute__((format(printf, 2, 3))) void message_print(FILE *out,
                                                         const char *format,
                                                         ...);

/* Until it is called with NULL, all errors name that place first, pel:
 * FILE:LINE: ...: for work that a script starts in functions without a line
 * number. */
void message_place(const char *file, long line);

#endif
