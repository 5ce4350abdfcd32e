#include "sim/cli/message.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The line of a script that errors name first. */
static const char *place_file;
static long place_line;

void message_place(const char *file, long line)
{
    place_file = file;
    place_line = line;
}

static void print_place(const char *file, long line)
{
    const bool is_input = strcmp(file, "-") == 0;
    fprintf(stderr, "%s:", is_input ? "(standard input)" : file);
    if (line > 0)
        fprintf(stderr, "%ld:", line);
    fputc(' ', stderr);
}

/* Control characters of files and arguments do not reach the terminal. */
__attribute__((format(printf, 1, 0))) static void print_text(const char *format,
                                                             va_list arguments)
{
    char *text;
    if (vasprintf(&text, format, arguments) < 0)
        return;
    for (const char *c = text; *c; c++)
        fputc((*c < ' ' && *c >= 0 && *c != '\n') || *c == 127 ? '?' : *c,
              stderr);
    free(text);
}

__attribute__((format(printf, 3, 0))) static void print_error(
    const char *file, long line, const char *format, va_list arguments)
{
    fprintf(stderr, "pel: ");
    if (place_file)
        print_place(place_file, place_line);
    if (file)
        print_place(file, line);
    print_text(format, arguments);
    fputc('\n', stderr);
}

bool message_error(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_error(NULL, 0, format, arguments);
    va_end(arguments);
    return false;
}

bool message_error_at(const char *file, long line, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_error(file, line, format, arguments);
    va_end(arguments);
    return false;
}
