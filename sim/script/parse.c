/* Reading scripts. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/image/glyph_text.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"
#include "sim/cli/text_line.h"
#include "sim/image/format_names.h"
#include "sim/script/parser.h"

enum {
    LINE_SIZE_MAX = 1 << 20, /* bytes */
    WORD_SIZE_MAX = 4096     /* as many bytes as a path may have */
};

/* The end of a text in quotes, which begins behind the first; \" \\ and \n
 * become what they stand for. NULL when the closing quote is missing, or
 * another character stands behind a backslash. */
static char *end_quote(char *text)
{
    char *to = text;
    for (; *text && *text != '"'; text++) {
        char c = *text;
        if (c == '\\') {
            c = *++text;
            if (!c || !strchr("\"\\n", c))
                return NULL;
            c = (char)(c == 'n' ? '\n' : c);
        }
        *to++ = c;
    }
    if (!*text)
        return NULL;
    *to = '\0';
    return text + 1;
}

/* Words keep their opening quote, as a sign. */
static bool split_words(struct script_parser *p, char *text)
{
    static const char space[] = " \t\r\n\v\f";
    p->word_count = 0;
    while (*(text += strspn(text, space))) {
        char *end =
            *text == '"' ? end_quote(text + 1) : text + strcspn(text, space);
        if (end && end - text > WORD_SIZE_MAX)
            return ERROR_AT(p, "a word of %ld bytes: expected up to %d",
                            (long)(end - text), WORD_SIZE_MAX);
        if (!end || (*end && !strchr(space, *end)))
            return ERROR_AT(p, "expected a text that ends with a quote and a "
                               "blank after it, with \\\", \\\\ and \\n in it");
        if (!list_add(&p->words, &p->word_count, &text, sizeof text))
            return false;
        text = end + (*end != '\0');
        *end = '\0';
    }
    return true;
}

/* The number of arguments that a command needs; more may follow in groups of
 * *group, none when that is 0. */
static size_t needed_of(const char *kinds, size_t *group)
{
    const size_t n = strcspn(kinds, "*+");
    *group = kinds[n] == '*' ? 2 : kinds[n] == '+' ? 3 : 0;
    return n;
}

/* When none are repeated, 0 behind the last one. */
char script_kind_of(const struct script_command *command, size_t i)
{
    size_t group;
    const char *kinds = command->kinds;
    const size_t needed = needed_of(kinds, &group);
    return i < needed || !group ? kinds[i]
                                : kinds[needed - group + (i - needed) % group];
}

static bool refuse_count(const struct script_parser *p, size_t given)
{
    static const char *const more[] = {"", "", " or more, in pairs",
                                       " or more, in threes"};
    const struct script_command *c = p->command;
    size_t group;
    const size_t needed = needed_of(c->kinds, &group);
    return ERROR_AT(p, "%s: %zu values: expected %zu%s: %s %s", c->name, given,
                    needed, more[group], c->name, c->usage);
}

/* Arguments from word `first` on. A word with # is a comment, unless a color
 * belongs there. */
static bool parse_arguments(struct script_parser *p, size_t first)
{
    struct script *script = p->script;
    size_t n = 0, group;
    const size_t needed = needed_of(p->command->kinds, &group);
    for (size_t i = first; i < p->word_count; i++, n++) {
        const char kind = script_kind_of(p->command, n);
        int32_t value;
        if (p->words[i][0] == '#' && kind != KIND_COLOR)
            break;
        if (!kind)
            return refuse_count(p, p->word_count - first);
        if (!script_argument(p, (enum script_kind)kind, p->words[i], &value) ||
            !list_add(&script->values, &script->value_count, &value,
                      sizeof value))
            return false;
    }
    return (n >= needed && (!group || (n - needed) % group == 0)) ||
           refuse_count(p, n);
}

static bool take_canvas(struct script_parser *p, const int32_t *v)
{
    struct script *script = p->script;
    if (script->width)
        return ERROR_AT(p, "a second canvas: expected one");
    script->width = v[0];
    script->height = v[1];
    if (!script->format)
        script->format = format_names[v[2]].format;
    p->font = p->outlines = -1;
    p->scene = (struct script_scene){.settings = scene_default, .texture = -1};
    p->scene.settings.camera.width = v[0];
    p->scene.settings.camera.height = v[1];
    return picture_size_legal(v[0], v[1]) ||
           ERROR_AT(p, "canvas: %d x %d pixels are too many: expected up to %d",
                    v[0], v[1], PICTURE_PIXELS_MAX);
}

/* A text that its font can show whole. */
static bool check_text(const struct script_parser *p, int32_t text)
{
    const struct script_asset *assets = p->script->assets;
    const char *c = assets[text].text;
    if (strcmp(p->command->name, "text outline") == 0)
        return p->outlines >= 0 ||
               ERROR_AT(p, "text without outlines: expected font outline FILE "
                           "before it");
    if (p->font < 0)
        return ERROR_AT(p, "text without a font: expected font FILE before it");
    while (*c) {
        const char *const from = c;
        const uint32_t code = pel_utf8_next(&c);
        const struct pel_font_asset *font = &assets[p->font].font;
        if (code != '\n' && !pel_glyph_find(&font, code))
            return ERROR_AT(p,
                            "text: the font has no %.*s (U+%04lX), and no "
                            "glyph for what it lacks",
                            (int)(c - from), from, (unsigned long)code);
    }
    return true;
}

static bool set_scene(struct script_parser *p, const struct script_item *item)
{
    struct script_pen pen = {.script = p->script, .scene = &p->scene};
    script_perform(&pen, item);
    return !pen.failed || ERROR_AT(p, "light %d: expected up to %d",
                                   SCENE_LIGHTS_MAX + 1, SCENE_LIGHTS_MAX);
}

/* Checks the line against those before it. */
static bool check_command(struct script_parser *p,
                          const struct script_item *item)
{
    const struct script_command *c = item->command;
    const int32_t *v = p->script->values + item->first;
    const char *wrong = c->check ? c->check(v, item->count) : NULL;
    if (wrong)
        return ERROR_AT(p, "%s: %s", c->name, wrong);
    if ((c->role == SCRIPT_SHAPE || c->role == SCRIPT_TEXT) && p->by_vertex)
        return ERROR_AT(p,
                        "%s: paint vertex colours triangles: expected another "
                        "paint first",
                        c->name);
    switch (c->role) {
    case SCRIPT_CANVAS:
        return take_canvas(p, v);
    case SCRIPT_PAINT:
    case SCRIPT_PAINT_VERTEX:
        p->by_vertex = c->role == SCRIPT_PAINT_VERTEX;
        return true;
    case SCRIPT_FONT:
        if (p->script->assets[v[item->count - 1]].size < 0)
            p->outlines = v[item->count - 1];
        else
            p->font = v[item->count - 1];
        return true;
    case SCRIPT_TEXT:
        return check_text(p, v[item->count - 1]);
    case SCRIPT_SCENE:
        return set_scene(p, item);
    case SCRIPT_BANDS:
        p->script->bands = v[0];
        return canvas_bands_legal(p->script->format, v[0]) ||
               ERROR_AT(p, "bands %d: expected a multiple of 8 for mono1_pages",
                        v[0]);
    default:
        return true;
    }
}

bool script_add_item(struct script *script, const struct script_item *item)
{
    if (item->count / 2 > script->polygon_max)
        script->polygon_max = item->count / 2;
    return list_add(&script->items, &script->item_count, item, sizeof *item);
}

bool script_add(struct script *script, const char *name, const int32_t *values,
                size_t n)
{
    const struct script_command *command = script_shapes;
    while (strcmp(command->name, name) != 0)
        command = script_next(command);
    const struct script_item item = {command, 0, script->value_count, n};
    bool done = true;
    for (size_t i = 0; i < n; i++)
        done = done && list_add(&script->values, &script->value_count,
                                &values[i], sizeof values[i]);
    return done && script_add_item(script, &item);
}

/* Adds what the line says to the script; cuts it into words. */
static bool parse_line(struct script_parser *p, char *text)
{
    struct script *script = p->script;
    const size_t first = script->value_count;
    size_t name_words;
    if (!split_words(p, text))
        return false;
    if (p->word_count == 0 || p->words[0][0] == '#')
        return true;
    if (!script_find_command(p, &name_words))
        return false;
    if (p->command->role != SCRIPT_CANVAS && !script->width)
        return ERROR_AT(
            p,
            "%s before the canvas: expected canvas WIDTH HEIGHT FORMAT first",
            p->command->name);
    if (!parse_arguments(p, name_words))
        return false;
    const struct script_item item = {p->command, p->line, first,
                                     script->value_count - first};
    return check_command(p, &item) && script_add_item(script, &item);
}

/* Takes a line into the caption: what the script begins with, while that is
 * comments. */
static void add_caption(FILE *caption, const char *text)
{
    text += strspn(text, "# \t");
    fprintf(caption, "%s%.*s", ftell(caption) ? " " : "",
            (int)strcspn(text, "\r\n"), text);
}

/* A line that is no text, or the end of the file. */
static bool check_end(const struct script_parser *p, FILE *file,
                      enum text_line got)
{
    if (ferror(file))
        return file_refuse(p->path);
    if (got == TEXT_LINE_ZERO)
        return ERROR_AT(p, "a zero byte: scripts are text");
    if (got == TEXT_LINE_LONG)
        return ERROR_AT(p, "a line of over %d bytes", LINE_SIZE_MAX);
    return p->script->width ||
           message_error_at(p->path, p->line - 1,
                            "no canvas: a script begins with canvas WIDTH "
                            "HEIGHT FORMAT");
}

static bool parse_lines(struct script_parser *p, FILE *file, FILE *caption)
{
    enum text_line got = TEXT_LINE;
    bool good = true, in_caption = true;
    char *text = malloc(LINE_SIZE_MAX + 1);
    if (!text || !caption)
        good = message_error("out of memory");
    while (good) {
        p->line++;
        got = text_line_read(file, text, LINE_SIZE_MAX + 1);
        if (got != TEXT_LINE)
            break;
        char *line = text + (p->line == 1 ? byte_order_mark(text) : 0);
        in_caption = in_caption && line[strspn(line, " \t")] == '#';
        if (in_caption)
            add_caption(caption, line);
        good = parse_line(p, line);
    }
    free(text);
    return good && check_end(p, file, got);
}

bool script_read(struct script *script, FILE *file, const char *path,
                 const struct pel_format *format)
{
    size_t size;
    struct script_parser parser = {.script = script, .path = path};
    *script = (struct script){.path = path, .format = format};
    FILE *caption = open_memstream(&script->caption, &size);
    const bool done = parse_lines(&parser, file, caption);
    free(parser.words);
    if (caption)
        fclose(caption);
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
    fclose(file);
    return done;
}

void script_free(struct script *script)
{
    script_free_assets(script);
    free(script->items);
    free(script->values);
    free(script->caption);
    *script = (struct script){0};
}
