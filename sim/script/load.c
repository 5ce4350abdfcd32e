#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/script/assets.h"
#include "sim/script/parser.h"
#include "sim/cli/text_line.h"

enum { LINE_SIZE_MAX = 1 << 20 }; /* bytes */

/* The comment at the head of the script. */
struct caption {
    FILE *stream;
    char *text;
    size_t size;
    bool ended;
};

/* Takes a line of the script into the caption, while nothing but comments has
 * come; an empty line ends it too. */
static void caption_add(struct caption *caption, const char *text)
{
    text += strspn(text, " \t");
    caption->ended = caption->ended || *text != '#';
    if (caption->ended)
        return;
    text += strspn(text, "# \t");
    const size_t length = strcspn(text, "\r\n");
    fprintf(caption->stream, "%s%.*s", ftell(caption->stream) ? " " : "",
            (int)length, text);
}

/* A line that is no text, or the end of the file. */
static bool refuse_line(const struct script_parser *p, FILE *file,
                        enum text_line got)
{
    const char *path = p->script->path;
    if (ferror(file))
        return message_error_at(path, 0, "cannot be read: %s", strerror(errno));
    if (got == TEXT_LINE_ZERO)
        return message_error_at(path, p->line + 1,
                                "a zero byte: scripts are text");
    return got != TEXT_LINE_LONG ||
           message_error_at(path, p->line + 1, "a line of over %d bytes",
                            LINE_SIZE_MAX);
}

static bool parse_lines(struct script_parser *p, FILE *file,
                        struct caption *caption)
{
    bool good = true;
    enum text_line got = TEXT_LINE;
    char *text = malloc(LINE_SIZE_MAX + 1);
    if (!text)
        return message_error("out of memory");
    while (good &&
           (got = text_line_read(file, text, LINE_SIZE_MAX + 1)) == TEXT_LINE) {
        char *line = text + (++p->line == 1 ? byte_order_mark(text) : 0);
        caption_add(caption, line);
        good = script_parse_line(p, line);
    }
    free(text);
    return good && refuse_line(p, file, got);
}

static bool load_from(struct script *script, FILE *file)
{
    struct script_parser parser = {.script = script};
    struct caption caption = {NULL, NULL, 0, false};
    caption.stream = open_memstream(&caption.text, &caption.size);
    if (!caption.stream)
        return message_error("out of memory");
    bool good = parse_lines(&parser, file, &caption);
    if (good && script->width == 0)
        good = message_error_at(script->path, parser.line,
                                "no canvas: a script begins with canvas WIDTH "
                                "HEIGHT FORMAT");
    free(parser.words);
    fclose(caption.stream);
    script->caption = caption.text;
    return good;
}

bool script_read(struct script *script, FILE *file, const char *path,
                 const struct pel_format *format)
{
    *script = (struct script){.path = path, .format = format};
    script->assets = calloc(1, sizeof *script->assets);
    if (!script->assets)
        return message_error("out of memory");
    const bool done = load_from(script, file);
    if (!done)
        script_free(script);
    return done;
}

bool script_load(struct script *script, const char *path,
                 const struct pel_format *format)
{
    FILE *file = file_open(path);
    *script = (struct script){.path = path};
    if (!file)
        return false;
    const bool done = script_read(script, file, path, format);
    file_close(file);
    return done;
}

void script_free(struct script *script)
{
    const struct script empty = {0};
    free(script->items);
    free(script->values);
    free(script->caption);
    if (script->assets)
        script_assets_free(script->assets);
    free(script->assets);
    *script = empty;
}
