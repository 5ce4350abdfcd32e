#include <stdio.h>
#include <string.h>

#include "core/image/glyph_text.h"
#include "sim/image/format_names.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"
#include "sim/script/assets.h"
#include "sim/script/parser.h"

/* The end of a text in quotes, which begins behind the first; \" \\ and \n
 * become what they stand for. NULL when the closing quote is missing, or
 * another character stands behind a backslash. */
static char *end_quote(char *text)
{
    char *to = text;
    for (; *text && *text != '"'; text++) {
        if (*text == '\\') {
            text++;
            if (!*text || !strchr("\"\\n", *text))
                return NULL;
            *to++ = (char)(*text == 'n' ? '\n' : *text);
        } else
            *to++ = *text;
    }
    if (!*text)
        return NULL;
    *to = '\0';
    return text + 1;
}

enum { WORD_SIZE_MAX = 4096 }; /* as many bytes as a path may have */

/* Words keep their opening quote, as a sign. */
static bool split_words(struct script_parser *p, char *text)
{
    static const char space[] = " \t\r\n\v\f";
    p->word_count = 0;
    while (*(text += strspn(text, space))) {
        char *end =
            *text == '"' ? end_quote(text + 1) : text + strcspn(text, space);
        if (end && end - text > WORD_SIZE_MAX)
            return message_error_at(p->script->path, p->line,
                                    "a word of %ld bytes: expected up to %d",
                                    (long)(end - text), WORD_SIZE_MAX);
        if (!end || (*end && !strchr(space, *end)))
            return message_error_at(p->script->path, p->line,
                                    "expected a text that ends with a quote "
                                    "and a blank after it, with \\\", \\\\ and "
                                    "\\n in it");
        if (!list_add(&p->words, &p->word_count, &text, sizeof text))
            return false;
        text = end + (*end != '\0');
        *end = '\0';
    }
    return true;
}

static const struct script_command *find_command(const struct script_parser *p,
                                                 size_t *name_words)
{
    for (const struct script_command *const *t = script_tables; *t; t++) {
        for (const struct script_command *c = *t; c->name; c++) {
            *name_words = script_common_words(p, c->name);
            if (*name_words == script_name_words(c->name))
                return c;
        }
    }
    script_refuse_unknown(p);
    return NULL;
}

/* The number of arguments that a command needs; more may follow in groups of
 * *group, none when that is 0. */
static size_t needed_of(const char *kinds, size_t *group)
{
    const size_t n = strcspn(kinds, "*+");
    *group = kinds[n] == '*' ? 2 : kinds[n] == '+' ? 3 : 0;
    return n;
}

/* The kind of argument i, or 0 when the command takes no more. */
static enum script_kind kind_at(const char *kinds, size_t i)
{
    size_t group;
    const size_t n = needed_of(kinds, &group);
    if (i >= n && group)
        i = n - group + (i - n) % group;
    return i < n ? (enum script_kind)kinds[i] : 0;
}

static bool refuse_count(const struct script_place *at, size_t given)
{
    static const char *const more[] = {"", "", " or more, in pairs",
                                       " or more, in threes"};
    size_t group;
    const size_t needed = needed_of(at->command->kinds, &group);
    return ERROR_AT(at, "%s: %zu values: expected %zu%s: %s %s",
                    at->command->name, given, needed, more[group],
                    at->command->name, at->command->usage);
}

/* Arguments from word `first` on. A word with # is a comment, unless a color
 * belongs there. */
static bool parse_arguments(struct script_parser *p,
                            const struct script_place *at, size_t first)
{
    size_t n = 0, group;
    const size_t needed = needed_of(at->command->kinds, &group);
    for (size_t i = first; i < p->word_count; i++, n++) {
        const enum script_kind kind = kind_at(at->command->kinds, n);
        int32_t value;
        if (p->words[i][0] == '#' && kind != KIND_COLOR)
            break;
        if (!kind)
            return refuse_count(at, p->word_count - first);
        if (!script_argument(at, kind, p->words[i], &value) ||
            !list_add(&p->script->values, &p->script->value_count, &value,
                      sizeof value))
            return false;
    }
    if (n < needed || (group && (n - needed) % group != 0))
        return refuse_count(at, n);
    return true;
}

static bool take_canvas(struct script_parser *p, const struct script_place *at,
                        const int32_t *v)
{
    struct script *script = p->script;
    if (script->width)
        return ERROR_AT(at, "a second canvas: expected one");
    script->width = v[0];
    script->height = v[1];
    if (!script->format)
        script->format = format_names[v[2]].format;
    if (!picture_size_legal(v[0], v[1]))
        return ERROR_AT(
            at, "canvas: %d x %d pixels are too many: expected up to %d", v[0],
            v[1], PICTURE_PIXELS_MAX);
    p->scene = (struct script_scene){.settings = scene_default, .texture = -1};
    p->scene.settings.camera.width = v[0];
    p->scene.settings.camera.height = v[1];
    return true;
}

/* A text that its font can show whole. */
static bool check_text(const struct script_parser *p,
                       const struct script_place *at, int32_t text)
{
    const struct script_assets *assets = at->assets;
    const char *c = assets->texts[text];
    if (!p->has_font)
        return ERROR_AT(at,
                        "text without a font: expected font FILE before it");
    while (*c) {
        const char *const from = c;
        const uint32_t code = pel_utf8_next(&c);
        if (code != '\n' &&
            !pel_glyph_find(&assets->fonts[assets->font_count - 1], code))
            return ERROR_AT(at,
                            "text: the font has no %.*s (U+%04lX), and no "
                            "glyph for what it lacks",
                            (int)(c - from), from, (unsigned long)code);
    }
    return true;
}

/* Checks the line against those before it; `v` are its values. */
static bool check_command(struct script_parser *p,
                          const struct script_place *at, const int32_t *v,
                          size_t n)
{
    const struct script_command *c = at->command;
    const char *wrong = c->check ? c->check(v, n) : NULL;
    if (wrong)
        return ERROR_AT(at, "%s: %s", c->name, wrong);
    if (c->role == SCRIPT_PAINT || c->role == SCRIPT_PAINT_VERTEX)
        p->by_vertex = c->role == SCRIPT_PAINT_VERTEX;
    p->has_font = p->has_font || c->role == SCRIPT_FONT;
    if (c->role == SCRIPT_TEXT && !check_text(p, at, v[2]))
        return false;
    if (c->role == SCRIPT_SCENE) {
        struct script_pen pen = {.scene = &p->scene, .assets = at->assets};
        script_perform(&pen, c, v, n);
        if (pen.failed)
            return ERROR_AT(at, "light %d: expected up to %d",
                            SCENE_LIGHTS_MAX + 1, SCENE_LIGHTS_MAX);
    }
    if ((c->role == SCRIPT_SHAPE || c->role == SCRIPT_TEXT) && p->by_vertex)
        return ERROR_AT(
            at,
            "%s: paint vertex colours triangles: expected another paint first",
            c->name);
    if (c->role == SCRIPT_BANDS && !canvas_bands_legal(p->script->format, v[0]))
        return ERROR_AT(
            at, "bands %d: expected a multiple of 8 for mono1_pages", v[0]);
    return true;
}

static bool parse_command(struct script_parser *p,
                          const struct script_place *at, size_t name_words)
{
    struct script *script = p->script;
    const size_t first = script->value_count;
    const bool is_canvas = at->command->role == SCRIPT_CANVAS;
    if (!is_canvas && !script->width)
        return ERROR_AT(
            at,
            "%s before the canvas: expected canvas WIDTH HEIGHT FORMAT first",
            at->command->name);
    if (!parse_arguments(p, at, name_words))
        return false;
    const struct script_item item = {at->command, at->line, first,
                                     script->value_count - first};
    const int32_t *v = script->values + first;
    if (item.count / 2 > script->polygon_max)
        script->polygon_max = item.count / 2;
    return (is_canvas ? take_canvas(p, at, v)
                      : check_command(p, at, v, item.count)) &&
           list_add(&script->items, &script->item_count, &item, sizeof item);
}

bool script_parse_line(struct script_parser *parser, char *text)
{
    struct script_place at = {parser->script->path, parser->line, NULL,
                              parser->script->assets, &parser->scene};
    size_t name_words;
    if (!split_words(parser, text))
        return false;
    if (parser->word_count == 0 || parser->words[0][0] == '#')
        return true;
    at.command = find_command(parser, &name_words);
    return at.command && parse_command(parser, &at, name_words);
}
