/* Files that are read, and lines of those that may be no text. */
#ifndef SIM_CLI_TEXT_LINE_H
#define SIM_CLI_TEXT_LINE_H

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Opens a file to read, for the caller to close; "-" is standard input. It may
 * be a pipe or have no end: reading fails when it takes longer, or has more
 * bytes, than --limit says. NULL, with a message. */
FILE *file_open(const char *path);

/* All bytes of a file, or what is left of one that is open, malloc'ed and with
 * a 0 behind the last. NULL without a message, with errno for file_refuse. */
char *file_read(const char *path, size_t *size);
char *file_rest(FILE *file, size_t *size);

/* The message of a file whose reading has just failed, from errno. False. */
bool file_refuse(const char *path);

/* The name of a file as another file has it: there "-" is a file's. */
static inline const char *file_named(const char *name)
{
    return strcmp(name, "-") == 0 ? "./-" : name;
}

enum text_line {
    TEXT_LINE,      /* one was read, perhaps an empty one */
    TEXT_LINE_NONE, /* the file ends here, or cannot be read: ferror() */
    TEXT_LINE_ZERO, /* a zero byte, which no text has */
    TEXT_LINE_LONG  /* it does not fit */
};

/* The next line, without its \n, into text[size]. */
enum text_line text_line_read(FILE *file, char *text, size_t size);

/* All lines of a file. */
struct text_lines {
    char **text; /* each without its \n */
    size_t count;
};

/* "-" is standard input. False, with a message; text_lines_free in any case. */
bool text_lines_read(struct text_lines *lines, const char *path);
void text_lines_free(struct text_lines *lines);

/* The first bytes of a file, at most size - 1 and with a 0 behind them; how
 * many, 0 when it cannot be read. */
size_t text_start(const char *path, char *text, size_t size);

/* Bytes of the UTF-8 byte order mark, which some editors write first: 3 where a
 * text begins with it, else 0. */
static inline size_t byte_order_mark(const char *text)
{
    return strncmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
}

#endif
