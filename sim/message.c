#include "message.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Of message_error. */
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

bool message_error(const char *format, ...)
{
    va_list arguments;
    fprintf(stderr, "pel: ");
    if (place_file)
        print_place(place_file, place_line);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return false;
}

bool message_error_at(const char *file, long line, const char *format, ...)
{
    va_list arguments;
    fprintf(stderr, "pel: ");
    print_place(file, line);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return false;
}
