#include "sim/cli/text_line.h"

#include <errno.h>

#include "sim/cli/list.h"
#include "sim/cli/message.h"

FILE *file_open(const char *path)
{
    FILE *file = strcmp(path, "-") == 0 ? stdin : fopen(path, "rb");
    if (!file)
        message_error_at(path, 0, "cannot be read: %s", strerror(errno));
    return file;
}

void file_close(FILE *file)
{
    if (file != stdin)
        fclose(file);
}

enum text_line text_line_read(FILE *file, char *text, size_t size)
{
    size_t n = 0;
    int c;
    while ((c = getc(file)) != EOF && c != '\n') {
        if (c == '\0')
            return TEXT_LINE_ZERO;
        if (n == size - 1)
            return TEXT_LINE_LONG;
        text[n++] = (char)c;
    }
    text[n] = '\0';
    return c == EOF && n == 0 ? TEXT_LINE_NONE : TEXT_LINE;
}

bool text_lines_read(struct text_lines *lines, const char *path)
{
    char *text = NULL;
    size_t size = 0;
    FILE *file = file_open(path);
    *lines = (struct text_lines){NULL, 0};
    if (!file)
        return false;
    while (getline(&text, &size, file) > 0 &&
           list_add(&lines->text, &lines->count, &text, sizeof text)) {
        text[strcspn(text, "\n")] = '\0';
        text = NULL;
    }
    free(text);
    const bool whole = feof(file) && !ferror(file);
    file_close(file);
    return whole || message_error_at(path, 0, "cannot be read");
}

void text_lines_free(struct text_lines *lines)
{
    for (size_t i = 0; i < lines->count; i++)
        free(lines->text[i]);
    free(lines->text);
}

size_t text_start(const char *path, char *text, size_t size)
{
    FILE *file = fopen(path, "rb");
    const size_t n = file ? fread(text, 1, size - 1, file) : 0;
    text[n] = '\0';
    if (file)
        fclose(file);
    return n;
}
