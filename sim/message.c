#include "message.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool message_error(const char *format, ...)
{
    va_list arguments;
    fprintf(stderr, "pel: ");
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return false;
}

bool message_error_at(const char *file, long line, const char *format, ...)
{
    va_list arguments;
    const bool is_input = strcmp(file, "-") == 0;
    fprintf(stderr, "pel: %s:", is_input ? "(standard input)" : file);
    if (line > 0)
        fprintf(stderr, "%ld:", line);
    fputc(' ', stderr);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return false;
}
