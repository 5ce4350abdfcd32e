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
bool message_error_at(const char *file, long line, const char *format, ...)
{
    char *text;
    va_list arguments;
    va_start(arguments, format);
    const int size = vasprintf(&text, format, arguments);
    va_end(arguments);
    fprintf(stderr, "pel: ");
    if (place_file)
        print_place(place_file, place_line);
    if (file)
        print_place(file, line);
    for (const char *c = text; size >= 0 && *c; c++)
        fputc((*c < ' ' && *c >= 0 && *c != '\n') || *c == 127 ? '?' : *c,
              stderr);
    fputc('\n', stderr);
    if (size >= 0)
        free(text);
    return false;
}
