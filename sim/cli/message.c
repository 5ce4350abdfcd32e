#include "sim/cli/message.h"

#include <stdarg.h>
#include <string.h>

#include "core/image/glyph_text.h"

enum {
    LINE_MOST = 480,  /* bytes that are shown of a text ... */
    PLACE_MOST = 140, /* ... and of a file's name before it */
    TEXT_SIZE = 8192  /* bytes that are looked at */
};

/* The line of a script that errors name first. */
static const char *place_file;
static long place_line;

void message_place(const char *file, long line)
{
    place_file = file;
    place_line = line;
}

/* Controls of both kinds, C0 and C1, ends of lines, what turns the direction of
 * writing or has no width, and bytes that are no UTF-8. */
static bool is_shown(uint32_t code, const char *bytes)
{
    static const struct {
        uint32_t first, last;
    } hidden[] = {{0, 0x1F},          {0x7F, 0x9F},        {0x200B, 0x200F},
                  {0x2028, 0x202E},   {0x2060, 0x206F},    {0xFEFF, 0xFEFF},
                  {0xE0000, 0xE0FFF}, {0x10FFFE, 0x10FFFF}};
    for (size_t i = 0; i < sizeof hidden / sizeof *hidden; i++)
        if (code >= hidden[i].first && code <= hidden[i].last)
            return false;
    return code != 0xFFFD || strncmp(bytes, "\xEF\xBF\xBD", 3) == 0;
}

/* What is not shown becomes a ? each. */
static void clean(char *text)
{
    char *to = text;
    for (const char *from = text; *from;) {
        const char *const start = from;
        const uint32_t code = pel_utf8_next(&from);
        const size_t n = (size_t)(from - start);
        if (is_shown(code, start)) {
            memmove(to, start, n);
            to += n;
        } else
            *to++ = '?';
    }
    *to = '\0';
}

static bool is_inside(char byte) /* a character */
{
    return ((unsigned char)byte & 0xC0) == 0x80;
}

/* Leaves out the middle of a text of more than `most` bytes. */
static void shorten(char *text, size_t most)
{
    static const char gap[] = " ... ";
    const size_t size = strlen(text);
    size_t head = most / 3 * 2, tail = size - most / 3 + sizeof gap;
    if (size <= most)
        return;
    while (is_inside(text[head]))
        head--;
    while (is_inside(text[tail]))
        tail++;
    memcpy(text + head, gap, sizeof gap - 1);
    head += sizeof gap - 1;
    memmove(text + head, text + tail, size - tail + 1);
}

/* The one way of all text that files, names and libraries have to a terminal.
 */
static void print(FILE *out, size_t most, const char *format, va_list arguments)
{
    char text[TEXT_SIZE];
    if (vsnprintf(text, sizeof text, format, arguments) < 0)
        return;
    clean(text);
    shorten(text, most);
    fputs(text, out);
}

__attribute__((format(printf, 3, 4))) static void print_most(FILE *out,
                                                             size_t most,
                                                             const char *format,
                                                             ...)
{
    va_list arguments;
    va_start(arguments, format);
    print(out, most, format, arguments);
    va_end(arguments);
}

void message_print(FILE *out, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print(out, LINE_MOST, format, arguments);
    va_end(arguments);
}

static size_t print_place(const char *file, long line)
{
    char number[24] = "";
    if (line > 0)
        snprintf(number, sizeof number, "%ld:", line);
    print_most(stderr, PLACE_MOST, "%s",
               strcmp(file, "-") == 0 ? "(standard input)" : file);
    fprintf(stderr, ":%s ", number);
    const size_t size = strlen(file) + strlen(number) + 2;
    return size < PLACE_MOST ? size : PLACE_MOST;
}

bool message_error_at(const char *file, long line, const char *format, ...)
{
    va_list arguments;
    size_t most = LINE_MOST;
    fputs("pel: ", stderr);
    if (place_file)
        most -= print_place(place_file, place_line);
    if (file)
        most -= print_place(file, line);
    va_start(arguments, format);
    print(stderr, most, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return false;
}
