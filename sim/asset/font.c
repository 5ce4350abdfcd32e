#include "sim/asset/import.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/image/glyph_text.h"
#include "sim/font/asset.h"
#include "sim/asset/text.h"
#include "sim/cli/arguments.h"
#include "sim/cli/message.h"

/* At *text, and moves it behind: a number as in C, or any character but a
 * digit, a comma and a hyphen. */
static bool next_code(const char **text, unsigned long *code)
{
    const char *start = *text;
    if (isdigit((unsigned char)*start)) {
        char *end;
        *code = strtoul(start, &end, 0);
        *text = end;
        return *code <= FONT_CODE_MAX;
    }
    if (strchr(",-", *start)) /* or the end */
        return false;
    *code = pel_utf8_next(text);
    return *code != 0xFFFD || strncmp(start, "\xEF\xBF\xBD", 3) == 0;
}

/* FIRST[-LAST] at *text, and moves it behind. */
static bool next_range(const char **text, unsigned long range[2])
{
    if (!next_code(text, &range[0]))
        return false;
    range[1] = range[0];
    if (**text != '-')
        return true;
    ++*text;
    return next_code(text, &range[1]) && range[0] <= range[1];
}

static bool codes_legal(const char *codes)
{
    unsigned long range[2];
    bool legal = next_range(&codes, range);
    while (legal && *codes == ',') {
        codes++;
        legal = next_range(&codes, range);
    }
    return legal && *codes == '\0';
}

static bool chars_legal(const char *text)
{
    unsigned long code = 0;
    while (*text && code != 0xFFFD)
        code = pel_utf8_next(&text);
    return code != 0 && code != 0xFFFD;
}

bool import_codes_check(const struct import_options *o)
{
    if (o->codes && !codes_legal(o->codes))
        return option_refuse("codes", o->codes,
                             "code points and characters such as "
                             "32-126,0x20AC,\xC3\xA4");
    return !o->chars || chars_legal(o->chars) ||
           option_refuse("chars", o->chars, "UTF-8");
}

/* Code points of --codes and --chars that the font lacks. */
struct lacking {
    unsigned long count;
    bool single; /* one of it was named by itself */
    bool more;   /* than the list has */
    char list[128];
};

static void add_lacking(struct lacking *l, unsigned long first,
                        unsigned long last)
{
    const size_t n = strlen(l->list), room = sizeof(l->list) - n;
    if (first > last)
        return;
    l->count += last - first + 1;
    if (room < 24)
        l->more = true;
    else if (first == last)
        snprintf(l->list + n, room, " U+%04lX", first);
    else
        snprintf(l->list + n, room, " U+%04lX-%04lX", first, last);
}

/* Marks the glyphs of a range. */
static void keep_range(const struct font *font, const unsigned long range[2],
                       bool *keep, struct lacking *lacking)
{
    const unsigned long before = lacking->count;
    unsigned long next = range[0];
    for (size_t i = 0; i < font->count; i++) {
        const unsigned long code = font->chars[i].code;
        if (code < range[0] || code > range[1])
            continue;
        keep[i] = true;
        add_lacking(lacking, next, code - 1);
        next = code + 1;
    }
    add_lacking(lacking, next, range[1]);
    if (range[0] == range[1] && lacking->count > before)
        lacking->single = true;
}

/* A range may have gaps, which a note names; what is named by itself is there.
 */
static bool check_lacking(const struct lacking *l, const char *path)
{
    if (l->count > 0)
        message_error_at(
            path, 0, "lacks %lu of --codes and --chars:%s%s%s", l->count,
            l->list, l->more ? " ..." : "",
            l->single ? ": expected a font that has them, or to do without"
                      : "");
    return !l->single;
}

/* Drops the glyphs that --codes and --chars leave out; they stay in order. */
static bool keep_codes(struct font *font, const struct import_options *o)
{
    struct lacking lacking = {0};
    unsigned long range[2];
    size_t kept = 0;
    bool *keep = calloc(font->count, sizeof(*keep));
    if (!keep)
        return message_error_at(o->source, 0, "out of memory");
    for (const char *p = o->codes; p && next_range(&p, range); p += *p == ',')
        keep_range(font, range, keep, &lacking);
    for (const char *p = o->chars; p && *p;) {
        range[0] = range[1] = pel_utf8_next(&p);
        keep_range(font, range, keep, &lacking);
    }
    for (size_t i = 0; i < font->count; i++)
        if (keep[i])
            font->chars[kept++] = font->chars[i];
    free(keep);
    font->count = kept;
    return (kept > 0 ||
            message_error_at(o->source, 0,
                             "has no character of %s: expected some that it "
                             "has",
                             o->codes ? o->codes : o->chars)) &&
           check_lacking(&lacking, o->source);
}

static void write_asset(struct import_text *text,
                        const struct pel_font_asset *font)
{
    FILE *out = text->output.stream;
    const char *name = text->options->name;
    const struct import_array bits = {"uint8_t", "bits", font->size, 1,
                                      font->bits};
    import_array(text, &bits);
    import_array_begin(text, "struct pel_font_glyph", "glyphs", font->glyphs,
                       1);
    for (uint32_t i = 0; i < font->glyphs; i++) {
        const struct pel_font_glyph *g = &font->glyph[i];
        import_item(text, "{%lu, %d, %d, %d, %d, %d},",
                    (unsigned long)g->offset, g->width, g->height, g->left,
                    g->top, g->advance);
    }
    import_array_end(text);
    import_array_begin(text, "struct pel_font_range", "ranges", font->ranges,
                       1);
    for (uint32_t i = 0; i < font->ranges; i++) {
        const struct pel_font_range *r = &font->range[i];
        import_item(text, "{%lu, %d, %d},", (unsigned long)r->first, r->count,
                    r->glyph);
    }
    import_array_end(text);
    import_struct_begin(text);
    fprintf(out, "    PEL_FONT_MAGIC,\n    PEL_FONT_VERSION,\n");
    fprintf(out, "    %u, /* px above the baseline */\n", font->ascent);
    fprintf(out, "    %u, /* px below it */\n", font->descent);
    fprintf(out, "    %u,\n    %u,\n    %u, /* glyph of what is missing */\n",
            font->ranges, font->glyphs, font->missing);
    fprintf(out, "    %lu,\n", (unsigned long)font->size);
    fprintf(out, "    %s_ranges,\n    %s_glyphs,\n    %s_bits,\n};\n", name,
            name, name);
}

static bool write_file(const struct import_options *options,
                       const struct pel_font_asset *asset)
{
    struct import_text text;
    if (!import_text_open(&text, options, "font"))
        return false;
    write_asset(&text, asset);
    return import_text_commit(&text);
}

bool import_font(const struct import_options *options)
{
    struct font font;
    struct pel_font_asset asset = {.magic = 0};
    const bool all = !options->codes && !options->chars;
    const bool done = font_load(&font, options->source) &&
                      (all || keep_codes(&font, options)) &&
                      font_add_box(&font) &&
                      font_asset_make(&asset, &font, options->source) &&
                      write_file(options, &asset);
    font_asset_free(&asset);
    font_free(&font);
    return done;
}
