#include "sim/asset/import.h"

#include <ctype.h>
#include <stdlib.h>

#include "sim/font/asset.h"
#include "sim/asset/text.h"
#include "sim/cli/message.h"

/* FIRST[-LAST] at *text, and moves it to what follows; numbers as in C. */
static bool next_range(const char **text, unsigned long range[2])
{
    const char *p = *text;
    for (int i = 0; i < 2; i++) {
        char *end;
        if (!isdigit((unsigned char)*p))
            return false;
        range[i] = strtoul(p, &end, 0);
        p = end;
        if (i == 0 && *p != '-')
            range[++i] = range[0];
        else if (i == 0)
            p++;
    }
    if (range[0] > range[1] || range[1] > FONT_CODE_MAX)
        return false;
    *text = p;
    return true;
}

bool import_codes_legal(const char *codes)
{
    unsigned long range[2];
    const char *p = codes;
    bool legal = next_range(&p, range);
    while (legal && *p == ',') {
        p++;
        legal = next_range(&p, range);
    }
    return (legal && *p == '\0') ||
           message_error("--codes is '%s'; code points such as 32-126,0x20AC "
                         "would be right",
                         codes);
}

static bool is_wanted(const char *codes, uint32_t code)
{
    unsigned long range[2];
    while (next_range(&codes, range)) {
        if (code >= range[0] && code <= range[1])
            return true;
        codes += *codes == ',';
    }
    return false;
}

/* Drops the glyphs that are not asked for; they stay in order. */
static bool keep_codes(struct font *font, const char *path, const char *codes)
{
    size_t kept = 0;
    for (size_t i = 0; i < font->count; i++)
        if (is_wanted(codes, font->chars[i].code))
            font->chars[kept++] = font->chars[i];
    font->count = kept;
    return kept > 0 || message_error_at(path, 0,
                                        "has no glyph of --codes %s; code "
                                        "points that it has would be right",
                                        codes);
}

static void write_bits(struct import_text *text, const char *name,
                       const struct pel_font_asset *font)
{
    const struct import_array array = {"uint8_t", "bits", font->size, 1};
    import_array_begin(text, name, &array);
    for (uint32_t i = 0; i < font->size; i++) {
        const long value = font->bits[i];
        import_array_item(text, &value, 1);
    }
    import_array_end(text);
}

static void write_glyphs(struct import_text *text, const char *name,
                         const struct pel_font_asset *font)
{
    const struct import_array array = {"struct pel_font_glyph", "glyphs",
                                       font->glyphs, 1};
    import_array_begin(text, name, &array);
    for (uint32_t i = 0; i < font->glyphs; i++) {
        const struct pel_font_glyph *g = &font->glyph[i];
        const long value[] = {(long)g->offset, g->width, g->height,
                              g->left,         g->top,   g->advance};
        import_array_item(text, value, 6);
    }
    import_array_end(text);
}

static void write_ranges(struct import_text *text, const char *name,
                         const struct pel_font_asset *font)
{
    const struct import_array array = {"struct pel_font_range", "ranges",
                                       font->ranges, 1};
    import_array_begin(text, name, &array);
    for (uint32_t i = 0; i < font->ranges; i++) {
        const struct pel_font_range *r = &font->range[i];
        const long value[] = {(long)r->first, r->count, r->glyph};
        import_array_item(text, value, 3);
    }
    import_array_end(text);
}

static void write_asset(struct import_text *text, const char *name,
                        const struct pel_font_asset *font)
{
    FILE *out = text->output.stream;
    write_bits(text, name, font);
    write_glyphs(text, name, font);
    write_ranges(text, name, font);
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
    write_asset(&text, options->name, asset);
    return import_text_commit(&text);
}

bool import_font(const struct import_options *options)
{
    struct font font;
    struct pel_font_asset asset;
    if (!font_load(&font, options->source))
        return false;
    bool done = (!options->codes ||
                 keep_codes(&font, options->source, options->codes)) &&
                font_asset_make(&asset, &font, options->source);
    if (done) {
        done = write_file(options, &asset);
        font_asset_free(&asset);
    }
    font_free(&font);
    return done;
}
