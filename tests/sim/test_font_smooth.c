/* Smooth glyphs of outlines beside FreeType's own grey levels. */
#include <stdio.h>
#include <stdlib.h>

#include <ft2build.h>
#include FT_FREETYPE_H

#include "sim/font/asset.h"
#include "tests/support/check.h"

static const char path[] = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

static int level_of(const struct font *font, const struct font_char *c, int x,
                    int y)
{
    const int column = x - c->left, row = c->top - y;
    return column >= 0 && row >= 0 && column < c->width && row < c->height
               ? font->bits[c->offset + (size_t)(row * c->width + column)]
               : 0;
}

static int level_there(const FT_GlyphSlot slot, int x, int y)
{
    const int column = x - slot->bitmap_left, row = slot->bitmap_top - y;
    const FT_Bitmap *b = &slot->bitmap;
    return column >= 0 && row >= 0 && column < (int)b->width &&
                   row < (int)b->rows
               ? b->buffer[row * b->pitch + column]
               : 0;
}

struct difference {
    long sum, pixels;
    int worst;
};

static void compare(const struct font *font, const struct font_char *c,
                    const FT_GlyphSlot slot, struct difference *d)
{
    for (int y = -80; y < 80; y++)
        for (int x = -40; x < 120; x++) {
            const int a = level_of(font, c, x, y);
            const int b = level_there(slot, x, y);
            const int far = abs(a - b);
            d->pixels += (a > 0 && a < 255) || far > 0;
            d->sum += far;
            d->worst = far > d->worst ? far : d->worst;
        }
}

static bool is_ascii(long code)
{
    return code < 127;
}

static bool is_digit(long code)
{
    return code >= '0' && code <= '9';
}

/* A frame of one pixel around nothing, as wide as the widest glyph. */
TEST(what_is_missing_is_a_box)
{
    const struct font_options options = {
        .size = 24, .bits = 4, .is_wanted = is_digit};
    struct font font;
    assert_true(font_load(&font, path, &options));
    assert_true(font_add_box(&font));
    const struct font_char *c = &font.chars[font.count - 1];
    const size_t n = (size_t)(c->width * c->height);
    int sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += font.bits[c->offset + i];
    assert_int_equal(c->code, FONT_CODE_MAX);
    assert_true(c->width > 5 && c->height == font.ascent);
    assert_int_equal(c->width, c->advance - 1);
    assert_int_equal(sum, 255 * 2 * (c->width + c->height - 2));
    font_free(&font);
}

/* FreeType rounds outlines to 1/64 px and curves to few lines. Where contours
 * overlap in a pixel it adds their areas, so accents stay out. */
TEST(levels_are_those_of_freetype)
{
    static const int size[] = {10, 14, 19, 28, 56};
    FT_Library library;
    FT_Face face;
    assert_int_equal(FT_Init_FreeType(&library), 0);
    if (FT_New_Face(library, path, 0, &face) != 0)
        fail_msg("%s is missing: the package fonts-dejavu-core brings it",
                 path);
    for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
        struct difference d = {0, 0, 0};
        struct font font;
        const struct font_options options = {
            .size = size[i], .bits = 4, .is_wanted = is_ascii};
        assert_true(font_load(&font, path, &options));
        assert_true(font.steps == 4 && font.pair_count > 0);
        FT_Size_RequestRec request = {FT_SIZE_REQUEST_TYPE_CELL, 0,
                                      size[i] * 64, 0, 0};
        do
            assert_int_equal(FT_Request_Size(face, &request), 0);
        while (face->size->metrics.ascender - face->size->metrics.descender >
                   size[i] * 64 &&
               (request.height -= 16) >= 64);
        for (size_t k = 0; k < font.count; k++) {
            assert_int_equal(
                FT_Load_Char(face, font.chars[k].code,
                             FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT),
                0);
            assert_int_equal(font.chars[k].advance,
                             (face->glyph->advance.x + 32) >> 6);
            compare(&font, &font.chars[k], face->glyph, &d);
        }
        printf("%d px: %.2f of 255 in the mean, %d at most\n", size[i],
               (double)d.sum / (double)d.pixels, d.worst);
        assert_true(d.sum < 3 * d.pixels && d.worst < 30);
        font_free(&font);
    }
    FT_Done_FreeType(library);
}
