#include "sim/asset/import.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/image/glyph_text.h"
#include "sim/font/asset.h"
#include "sim/font/outline_asset.h"
#include "sim/asset/report.h"
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

/* How each code point is wanted by --codes and --chars. */
enum { RANGED = 1, NAMED = 2 };
static uint8_t wanted[FONT_CODE_MAX + 2];

static bool want_codes(const char *codes)
{
    unsigned long range[2];
    do {
        if (!next_range(&codes, range))
            return false;
        if (range[0] == range[1])
            wanted[range[0]] = NAMED;
        for (; range[0] <= range[1]; range[0]++)
            wanted[range[0]] |= RANGED;
    } while (*codes++ == ',');
    return codes[-1] == '\0';
}

static bool want_chars(const char *text)
{
    uint32_t code = 0;
    while (*text && code != 0xFFFD) {
        code = pel_utf8_next(&text);
        wanted[code] = NAMED;
    }
    return code != 0 && code != 0xFFFD;
}

bool import_codes_check(const struct import_options *o)
{
    if (o->codes && !want_codes(o->codes))
        return option_refuse("codes", o->codes,
                             "code points and characters such as "
                             "32-126,0x20AC,\xC3\xA4");
    return !o->chars || want_chars(o->chars) ||
           option_refuse("chars", o->chars, "UTF-8");
}

/* Names what is still wanted. A range may have gaps, which is a note; what was
 * named by itself is there. */
static bool check_lacking(const char *path)
{
    char list[128] = "";
    unsigned long count = 0;
    bool named = false, more = false;
    for (unsigned long code = 0; code <= FONT_CODE_MAX; code++) {
        const unsigned long first = code;
        const size_t n = strlen(list), room = sizeof(list) - n;
        for (; wanted[code]; code++)
            named = named || wanted[code] & NAMED;
        if (code == first)
            continue;
        count += code - first;
        more = more || room < 24;
        if (!more)
            snprintf(list + n, room,
                     code - first > 1 ? " U+%04lX-%04lX" : " U+%04lX", first,
                     code - 1);
    }
    if (count > 0)
        message_error_at(
            path, 0, "lacks %lu of --codes and --chars:%s%s%s", count, list,
            more ? " ..." : "",
            named ? ": expected a font that has them, or to do without" : "");
    return !named;
}

/* Drops the glyphs that --codes and --chars leave out; they stay in order. */
static bool keep_codes(struct font *font, const struct import_options *o)
{
    size_t kept = 0;
    for (size_t i = 0; i < font->count; i++)
        if (wanted[font->chars[i].code]) {
            wanted[font->chars[i].code] = 0;
            font->chars[kept++] = font->chars[i];
        }
    font->count = kept;
    return (kept > 0 || message_error_at(
                            o->source, 0,
                            "has no character of %s: expected some that it has",
                            o->codes ? o->codes : o->chars)) &&
           check_lacking(o->source);
}

static void write_pairs(struct import_text *text,
                        const struct pel_font_asset *font)
{
    import_array_begin(text, "struct pel_font_pair", "pairs", font->pairs, 1);
    for (uint32_t i = 0; i < font->pairs; i++) {
        const struct pel_font_pair *p = &font->pair[i];
        import_item(text, "{%d, %d, %d},", p->left, p->right, p->x);
    }
    import_array_end(text);
}

static void write_ranges(struct import_text *text,
                         const struct pel_font_range *range, uint32_t n)
{
    import_array_begin(text, "struct pel_font_range", "ranges", n, 1);
    for (; n > 0; n--, range++)
        import_item(text, "{%lu, %d, %d},", (unsigned long)range->first,
                    range->count, range->glyph);
    import_array_end(text);
}

static void write_asset(struct import_text *text,
                        const struct pel_font_asset *font)
{
    FILE *out = text->output.stream;
    const char *name = text->options->name, *next = text->options->next;
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
    write_ranges(text, font->range, font->ranges);
    if (font->pairs)
        write_pairs(text, font);
    if (next)
        fprintf(out, "\nextern const struct pel_font_asset %s;\n", next);
    import_struct_begin(text);
    fprintf(out, "    PEL_FONT_MAGIC,\n    PEL_FONT_VERSION,\n");
    fprintf(out, "    %u, /* px above the baseline */\n", font->ascent);
    fprintf(out, "    %u, /* px below it */\n", font->descent);
    fprintf(out, "    %u,\n    %u,\n    %u, /* glyph of what is missing */\n",
            font->ranges, font->glyphs, font->missing);
    fprintf(out, "    %lu,\n", (unsigned long)font->size);
    fprintf(out, "    %s_ranges,\n    %s_glyphs,\n    %s_bits,\n", name, name,
            name);
    fprintf(out, "    %s,\n",
            !font->kind             ? "NULL"
            : font->kind->bits == 4 ? "&pel_font_smooth"
            : font->kind->bits == 2 ? "&pel_font_smooth_2"
                                    : "&pel_font_smooth_8");
    fprintf(out, "    %s%s,\n    %u,\n", font->pairs ? name : "NULL",
            font->pairs ? "_pairs" : "", font->pairs);
    fprintf(out, "    %s%s,\n};\n", next ? "&" : "", next ? next : "NULL");
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

static void write_outlines(struct import_text *text,
                           const struct pel_outline_font_asset *font)
{
    FILE *out = text->output.stream;
    const char *name = text->options->name;
    const struct import_array points = {"uint8_t", "points", font->size, 1,
                                        font->points};
    import_array(text, &points);
    import_array_begin(text, "struct pel_outline_glyph", "glyphs", font->glyphs,
                       1);
    for (uint32_t i = 0; i < font->glyphs; i++)
        import_item(text, "{%lu, %u, %u},",
                    (unsigned long)font->glyph[i].offset, font->glyph[i].size,
                    font->glyph[i].advance);
    import_array_end(text);
    write_ranges(text, font->range, font->ranges);
    if (font->pairs)
        import_array_begin(text, "struct pel_outline_pair", "pairs",
                           font->pairs, 1);
    for (uint32_t i = 0; i < font->pairs; i++)
        import_item(text, "{%u, %u, %d},", font->pair[i].left,
                    font->pair[i].right, font->pair[i].x);
    if (font->pairs)
        import_array_end(text);
    import_struct_begin(text);
    fprintf(out, "    PEL_OUTLINE_FONT_MAGIC,\n");
    fprintf(out, "    PEL_OUTLINE_FONT_VERSION,\n");
    fprintf(out, "    %u, /* units of an em */\n", font->em);
    fprintf(out, "    %u, /* above the baseline */\n", font->ascent);
    fprintf(out, "    %u, /* below it */\n", font->descent);
    fprintf(out, "    %d,\n    %d,\n    %d,\n    %d,\n", font->left,
            font->bottom, font->right, font->top);
    fprintf(out, "    %u,\n    %u,\n    %u,\n", font->ranges, font->glyphs,
            font->pairs);
    fprintf(out, "    %u, /* glyph of what is missing */\n", font->missing);
    fprintf(out, "    %lu,\n", (unsigned long)font->size);
    fprintf(out, "    %s_ranges,\n    %s_glyphs,\n    %s_points,\n", name, name,
            name);
    fprintf(out, "    %s%s,\n};\n", font->pairs ? name : "NULL",
            font->pairs ? "_pairs" : "");
}

static bool import_outlines(const struct import_options *options,
                            struct font *font)
{
    struct pel_outline_font_asset asset;
    struct import_text text;
    bool done = outline_add_box(font) &&
                outline_asset_make(&asset, font, options->source);
    if (!done)
        return false;
    done = import_text_open(&text, options, "outline_font");
    if (done) {
        write_outlines(&text, &asset);
        done = import_text_commit(&text);
    }
    if (done)
        report_outlines(options, &asset);
    outline_asset_free(&asset);
    return done;
}

static bool import_pictures(const struct import_options *options,
                            struct font *font)
{
    struct pel_font_asset asset = {.magic = 0};
    const bool done = font_add_box(font) &&
                      font_asset_make(&asset, font, options->source) &&
                      write_file(options, &asset);
    if (done)
        report_font(options, &asset);
    font_asset_free(&asset);
    return done;
}

static bool is_wanted(long code)
{
    return code >= 0 && code <= FONT_CODE_MAX && wanted[code];
}

bool import_font(const struct import_options *options)
{
    struct font font;
    const bool all = !options->codes && !options->chars;
    struct font_options reading = options->font;
    reading.is_wanted = all ? NULL : is_wanted;
    const bool done =
        font_load(&font, options->source, &reading) &&
        (all || keep_codes(&font, options)) &&
        (font.em ? import_outlines : import_pictures)(options, &font);
    font_free(&font);
    return done;
}
