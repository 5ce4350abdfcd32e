/* What FreeType reads: TrueType, OpenType, WOFF and Type 1, and fonts of
 * bitmaps such as PCF. */
#include "sim/font/font.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/bytes.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"

#ifdef HAVE_FREETYPE
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_BDF_H
#include FT_FONT_FORMATS_H
#include FT_GZIP_H
#include FT_SYSTEM_H

#include "sim/font/charset.h"
#include "sim/font/kerning.h"
#include "sim/font/outline.h"

struct reading {
    struct font *font;
    const struct font_file *file;
    FT_Library library;
    FT_Face face;
    struct charset charset;
    unsigned failed, large; /* glyphs */
};

static void *allocate(FT_Memory memory, long size)
{
    (void)memory;
    return malloc((size_t)size);
}

static void release(FT_Memory memory, void *block)
{
    (void)memory;
    free(block);
}

static void *resize(FT_Memory memory, long before, long size, void *block)
{
    (void)memory;
    (void)before;
    return realloc(block, (size_t)size);
}

/* The last four bytes say how large it is, which is at most 1,032 times as
 * much. */
bool font_unpack(struct font_file *file)
{
    struct FT_MemoryRec_ memory = {NULL, allocate, release, resize};
    const uint8_t *packed = (const uint8_t *)file->data;
    const size_t size =
        file->size < 18 ? 0 : bytes_little(packed + file->size - 4, 4);
    const bool possible = size > 0 && size <= 1032 * file->size;
    char *data = calloc(possible ? size + 1 : 1, 1);
    FT_ULong got = size;
    if (!data)
        return message_error_at(file->path, 0, "out of memory");
    const bool done = possible &&
                      FT_Gzip_Uncompress(&memory, (FT_Byte *)data, &got, packed,
                                         file->size) == 0 &&
                      got == size;
    free(file->data);
    file->data = data;
    file->size = size;
    return done || message_error_at(file->path, 0,
                                    "cannot be unpacked: expected a whole "
                                    "file that gzip has made");
}

/* Lines are as high as was asked for, or a little less, with ascent and descent
 * in whole pixels; of a font of bitmaps as high as they are. */
static bool set_size(const struct reading *r)
{
    const FT_Size_Metrics *m = &r->face->size->metrics;
    const long most = r->file->options.size * 64L;
    FT_Size_RequestRec request = {FT_SIZE_REQUEST_TYPE_CELL, 0, most, 0, 0};
    bool done = false;
    if (r->font->em) /* a unit is a pixel */
        done = FT_Set_Pixel_Sizes(r->face, 0, (FT_UInt)r->font->em) == 0;
    else if (!FT_IS_SCALABLE(r->face))
        done = FT_Select_Size(r->face, 0) == 0;
    else
        do
            done = FT_Request_Size(r->face, &request) == 0;
        while (m->ascender - m->descender > most &&
               (request.height -= 16) >= 64);
    return done || message_error_at(r->file->path, 0,
                                    "has no glyphs of that size: expected "
                                    "another --font-size");
}

/* The encoding of a font of X11, by its properties or by its name; "": Unicode,
 * or what nobody knows. */
static void name_charset(const struct reading *r, char *name, size_t size)
{
    const char *registry = NULL, *encoding = NULL;
    BDF_PropertyRec full;
    if (r->file->options.encoding)
        snprintf(name, size, "%s", r->file->options.encoding);
    else if (FT_Get_BDF_Charset_ID(r->face, &encoding, &registry) == 0 &&
             registry)
        snprintf(name, size, "%s-%s", registry, encoding);
    else if (FT_Get_BDF_Property(r->face, "FONT", &full) == 0 &&
             full.type == BDF_PROPERTY_TYPE_ATOM && full.u.atom)
        snprintf(name, size, "%s", charset_of_name(full.u.atom));
}

/* Outlines with characters of Unicode have no codes to give a meaning to. */
static bool check_encoding(const struct reading *r)
{
    return !r->file->options.encoding || !FT_IS_SCALABLE(r->face) ||
           FT_Select_Charmap(r->face, FT_ENCODING_UNICODE) != 0 ||
           message_error_at(r->file->path, 0,
                            "has the characters of Unicode: expected no "
                            "--encoding");
}

/* The map of FreeType's own is Unicode; other codes are those of the font. */
static bool set_charset(struct reading *r)
{
    FT_Face face = r->face;
    char name[128] = "";
    name_charset(r, name, sizeof name);
    if ((*name || !face->charmap) && face->num_charmaps > 0) {
        FT_CharMap map = face->charmaps[0];
        for (int i = 0; i < face->num_charmaps; i++)
            if (face->charmaps[i]->encoding != FT_ENCODING_UNICODE)
                map = face->charmaps[i];
        FT_Set_Charmap(face, map);
        if (map->encoding == FT_ENCODING_UNICODE && !r->file->options.encoding)
            *name = '\0';
    }
    return face->charmap
               ? charset_open(&r->charset, name, r->file->path)
               : message_error_at(r->file->path, 0,
                                  "has no table of characters: expected a "
                                  "font with one");
}

static bool is_wanted(const struct reading *r, long character)
{
    const struct font_options *o = &r->file->options;
    return !o->is_wanted || o->is_wanted(character);
}

static FT_Int32 flags_of(const struct reading *r)
{
    const enum font_hinting hinting = r->file->options.hinting;
    const FT_Int32 full =
        r->font->steps ? FT_LOAD_TARGET_NORMAL : FT_LOAD_TARGET_MONO;
    if (!FT_IS_SCALABLE(r->face))
        return FT_LOAD_TARGET_MONO | FT_LOAD_MONOCHROME;
    if (hinting == FONT_UNHINTED || r->font->em)
        return FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP;
    if (hinting == FONT_HINTING)
        return FT_LOAD_NO_BITMAP |
               (r->font->steps ? FT_LOAD_TARGET_LIGHT : FT_LOAD_TARGET_MONO);
    return FT_LOAD_NO_BITMAP |
           (hinting == FONT_HINTED_FULL ? full : FT_LOAD_TARGET_LIGHT);
}

/* Loads a glyph: its outline, or its picture in one bit. */
static bool load(const struct reading *r, FT_UInt index)
{
    const FT_GlyphSlot slot = r->face->glyph;
    if (FT_Load_Glyph(r->face, index, flags_of(r)) != 0)
        return false;
    if (r->font->steps || r->font->em)
        return slot->format == FT_GLYPH_FORMAT_OUTLINE;
    return FT_Render_Glyph(slot, FT_RENDER_MODE_MONO) == 0 &&
           (!slot->bitmap.buffer ||
            slot->bitmap.pixel_mode == FT_PIXEL_MODE_MONO);
}

/* Adds the loaded glyph as points. */
static bool add_points(struct reading *r, struct font_char *c)
{
    const FT_GlyphSlot slot = r->face->glyph;
    struct font_points points = {.size = 0};
    outline_put(&slot->outline, &points);
    const bool large = points.beyond || points.size > UINT16_MAX ||
                       c->advance < 0 || c->advance > UINT16_MAX;
    const bool done = large || font_points_keep(r->font, c, &points);
    r->large += large;
    free(points.bytes);
    return done;
}

/* Draws a glyph into the font. */
static bool add(struct reading *r, FT_UInt index, long character)
{
    enum { MOST = FONT_SIZE_MAX };
    const FT_GlyphSlot slot = r->face->glyph;
    uint8_t *level = NULL;
    if ((r->font->steps || r->font->em) && !is_wanted(r, character))
        return true;
    if (!load(r, index)) {
        r->failed += is_wanted(r, character);
        return true;
    }
    struct font_char c = {.code = (uint32_t)character,
                          .width = (int)slot->bitmap.width,
                          .height = (int)slot->bitmap.rows,
                          .left = slot->bitmap_left,
                          .top = slot->bitmap_top,
                          .advance = (int)(slot->advance.x + 32) >> 6};
    if (r->font->em)
        return add_points(r, &c);
    if (r->font->steps && !(level = outline_draw(&slot->outline, &c)))
        return false;
    if (c.width > MOST || c.height > MOST || c.left < -MOST || c.left > MOST ||
        c.top > MOST || c.top - c.height < -MOST || c.advance < 0 ||
        c.advance > MOST) {
        r->large += is_wanted(r, character);
        free(level);
        return true;
    }
    const bool done = level ? font_add(r->font, &c, level, (size_t)c.width)
                            : font_add(r->font, &c, slot->bitmap.buffer,
                                       (size_t)abs(slot->bitmap.pitch));
    free(level);
    return done;
}

/* The pairs of the first characters that are wanted, as many as an asset can
 * have pairs of. */
static bool add_pairs(const struct reading *r)
{
    enum { MOST = 256 };
    uint32_t code[MOST];
    size_t n = 0;
    struct kerning kerning;
    bool done = true;
    for (size_t i = 0; i < r->font->count && n < MOST; i++)
        if (is_wanted(r, r->font->chars[i].code))
            code[n++] = r->font->chars[i].code;
    kerning_open(&kerning, r->face, r->file);
    for (size_t i = 0; done && i < n * n; i++) {
        const uint32_t left = code[i / n], right = code[i % n];
        const struct font_pair pair = {
            left, right, (kerning_of(&kerning, left, right) + 32) >> 6};
        done = !pair.x || list_add(&r->font->pairs, &r->font->pair_count, &pair,
                                   sizeof pair);
    }
    kerning_close(&kerning);
    return done;
}

static void report(const struct reading *r)
{
    if (r->failed > 0)
        message_error_at(r->file->path, 0,
                         "%u glyphs cannot be drawn and are left out",
                         r->failed);
    if (r->large > 0 && r->font->em)
        message_error_at(r->file->path, 0,
                         "%u glyphs are left out: expected points of -32768 "
                         "to 32767 units, of at most 65535 bytes",
                         r->large);
    else if (r->large > 0)
        message_error_at(r->file->path, 0,
                         "%u glyphs are left out: expected glyphs and "
                         "advances of 0 to %d px, within -%d to %d of the "
                         "origin",
                         r->large, FONT_SIZE_MAX, FONT_SIZE_MAX, FONT_SIZE_MAX);
    charset_report(&r->charset, r->file->path);
}

static bool same(const struct font *font, const struct font_char *a,
                 const struct font_char *b)
{
    return a->width == b->width && a->height == b->height &&
           a->left == b->left && a->top == b->top && a->advance == b->advance &&
           memcmp(font->bits + a->offset, font->bits + b->offset,
                  ((size_t)a->width + 7) / 8 * (size_t)a->height) == 0;
}

/* A PCF has its glyph for what is missing as number 0, and no property says of
 * which character it is: it was added first. */
static void find_missing(struct font *font)
{
    size_t i = 1;
    while (i < font->count && !same(font, &font->chars[0], &font->chars[i]))
        i++;
    if (i < font->count)
        font->missing = (long)font->chars[i].code;
    font->count--;
    memmove(font->chars, font->chars + 1, font->count * sizeof *font->chars);
}

static bool add_all(struct reading *r)
{
    FT_UInt index;
    const bool is_pcf = strcmp(FT_Get_Font_Format(r->face), "PCF") == 0;
    bool done = !is_pcf || add(r, 0, FONT_CODE_MAX);
    const bool has_missing = r->font->count > 0;
    for (FT_ULong code = FT_Get_First_Char(r->face, &index); done && index != 0;
         code = FT_Get_Next_Char(r->face, code, &index)) {
        const long character = charset_code(&r->charset, (uint32_t)code);
        done = character < 0 || add(r, index, character);
    }
    if (has_missing)
        find_missing(r->font);
    return done;
}

static bool set_lines(const struct reading *r)
{
    const FT_Size_Metrics *m = &r->face->size->metrics;
    const int most = r->font->em ? INT16_MAX : FONT_SIZE_MAX;
    r->font->ascent = (int)((m->ascender + 32) >> 6);
    r->font->descent = (int)((32 - m->descender) >> 6);
    return (r->font->ascent >= 0 && r->font->ascent <= most &&
            r->font->descent >= 0 && r->font->descent <= most) ||
           message_error_at(r->file->path, 0,
                            "lines reach from %d above to %d below the "
                            "baseline: expected 0 to %d %s",
                            r->font->ascent, r->font->descent, most,
                            r->font->em ? "units" : "px");
}

/* An em of 256 units at least: core/image/outline_text.c divides by it. */
static bool take_em(const struct reading *r)
{
    const int em = FT_IS_SCALABLE(r->face) ? r->face->units_per_EM : 256;
    r->font->em = FT_IS_SCALABLE(r->face) ? em : 0;
    return (em >= 256 && em <= 16384) ||
           message_error_at(r->file->path, 0,
                            "has an em of %d units: expected 256 to 16384", em);
}

/* The process ends after it, and with it what it has taken. */
bool font_parse_other(struct font *font, const struct font_file *file)
{
    struct reading r = {.font = font, .file = file};
    if (FT_Init_FreeType(&r.library) != 0)
        return message_error_at(file->path, 0, "out of memory");
    if (FT_New_Memory_Face(r.library, (const FT_Byte *)file->data,
                           (FT_Long)file->size, 0, &r.face) != 0)
        return message_error_at(file->path, 0,
                                "is no font: expected a BDF, PSF, PCF, "
                                "TrueType, OpenType, WOFF or Type 1 file");
    if (file->options.outline && !take_em(&r))
        return false;
    if (FT_IS_SCALABLE(r.face) && !font->em)
        font->steps = file->options.bits == 0   ? 4
                      : file->options.bits == 1 ? 0
                                                : file->options.bits;
    if (!set_size(&r) || !check_encoding(&r) || !set_charset(&r) ||
        !set_lines(&r) || !add_all(&r))
        return false;
    report(&r);
    return (!font->steps && !font->em) || add_pairs(&r);
}

#else

static bool refuse(const struct font_file *file, const char *what)
{
    return message_error_at(file->path, 0,
                            "%s, and this pel was built without FreeType, "
                            "which the package libfreetype-dev brings: "
                            "expected a BDF or PSF file",
                            what);
}

bool font_unpack(struct font_file *file)
{
    return refuse(file, "is packed by gzip");
}

bool font_parse_other(struct font *font, const struct font_file *file)
{
    (void)font;
    return refuse(file, "is no BDF or PSF font");
}

#endif
