/* Smooth glyphs of outlines beside FreeType's own grey levels. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "core/format/formats.h"
#include "core/image/glyph_text.h"
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

/* Sans, a face of one width, and two with serifs, of TrueType, OpenType and
 * Type 1: packages fonts-dejavu-core, fonts-noto-mono, fonts-urw-base35. */
static const char *const paths[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf",
    "/usr/share/fonts/truetype/noto/NotoSansMono-Regular.ttf",
    "/usr/share/fonts/opentype/urw-base35/C059-Roman.otf",
    "/usr/share/fonts/type1/urw-base35/C059-Roman.t1"};
static const int sizes[] = {8, 10, 12, 14, 16, 20, 28, 40, 64};
enum {
    PATHS = sizeof paths / sizeof *paths,
    SIZES = sizeof sizes / sizeof *sizes
};

static int wanted_rest; /* of codes by 16; below 0: all */

static bool is_sampled(long code)
{
    return wanted_rest < 0 || code % 16 == wanted_rest;
}

/* A glyph alone, as the asset has it, is what the font's levels are in steps.
 */
static void check_glyph(const struct pel_font_asset *asset,
                        const struct font *font, const struct font_char *c)
{
    static uint8_t pixels[256 * 256];
    const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    const int most = (1 << font->steps) - 1;
    const struct pel_font_asset *at = asset;
    const struct pel_font_glyph *g = pel_glyph_find(&at, c->code);
    struct pel_surface s;
    pel_surface_init(&s, &pel_gray8, pixels, sizeof pixels,
                     &(struct pel_rect){0, 0, 256, 256});
    memset(pixels, 0, sizeof pixels);
    at->kind->draw(&s, at, g, (struct pel_point){0, 0}, &white.paint);
    for (int y = 0; y < c->height; y++)
        for (int x = 0; x < c->width; x++) {
            const int level =
                font->bits[c->offset + (size_t)(y * c->width + x)];
            const int step = (level * most + 127) / 255;
            if (pixels[y * 256 + x] != step * 255 / most)
                fail_msg("U+%04lX, %d bits: pixel %d, %d is %d, not %d of %d",
                         (unsigned long)c->code, font->steps, x, y,
                         pixels[y * 256 + x], step, most);
        }
}

/* PEL_SCALE=100: all glyphs, not each sixteenth. */
TEST(glyphs_are_decoded_as_they_were_encoded)
{
    const char *scale = getenv("PEL_SCALE");
    const bool all = scale && atoi(scale) > 100;
    for (int i = 0; i < PATHS * SIZES * 3; i++) {
        const struct font_options options = {.size = sizes[i / 3 % SIZES],
                                             .bits = 2 << i % 3,
                                             .is_wanted = is_sampled};
        struct pel_font_asset asset;
        struct font font;
        wanted_rest = all ? -1 : i % 16;
        assert_true(font_load(&font, paths[i / 3 / SIZES], &options));
        assert_true(font.count > 10);
        size_t n = 0;
        for (size_t k = 0; k < font.count; k++)
            if (is_sampled((long)font.chars[k].code))
                font.chars[n++] = font.chars[k];
        font.count = n;
        assert_true(font_asset_make(&asset, &font, paths[i / 3 / SIZES]));
        assert_int_equal(pel_font_asset_check(&asset), PEL_OK);
        for (size_t k = 0; k < font.count; k++)
            check_glyph(&asset, &font, &font.chars[k]);
        font_asset_free(&asset);
        font_free(&font);
    }
}

/* Sides of an outline, px, y upwards; the exact area of a pixel is the mean of
 * LINES rows of exact lengths, where the winding is not 0. */
enum { SIDES = 8192, LINES = 128 };
struct sides {
    double from[SIDES][2], to[SIDES][2], at[2], begin[2];
    int n;
};

static void add_side(struct sides *o, double x, double y)
{
    assert_true(o->n < SIDES);
    memcpy(o->from[o->n], o->at, sizeof o->at);
    o->at[0] = o->to[o->n][0] = x;
    o->at[1] = o->to[o->n][1] = y;
    o->n++;
}

static int side_move(const FT_Vector *to, void *user)
{
    struct sides *o = user;
    add_side(o, o->begin[0], o->begin[1]);
    o->at[0] = o->begin[0] = (double)to->x / 64;
    o->at[1] = o->begin[1] = (double)to->y / 64;
    return 0;
}

static int side_line(const FT_Vector *to, void *user)
{
    add_side(user, (double)to->x / 64, (double)to->y / 64);
    return 0;
}

static int side_cubic(const FT_Vector *b, const FT_Vector *c,
                      const FT_Vector *to, void *user)
{
    struct sides *o = user;
    const double a[] = {o->at[0], o->at[1]};
    for (int i = 1; i <= 64; i++) {
        const double t = i / 64.0, u = 1 - t;
        add_side(o,
                 u * u * u * a[0] + (3 * u * u * t * (double)b->x +
                                     3 * u * t * t * (double)c->x +
                                     t * t * t * (double)to->x) /
                                        64,
                 u * u * u * a[1] + (3 * u * u * t * (double)b->y +
                                     3 * u * t * t * (double)c->y +
                                     t * t * t * (double)to->y) /
                                        64);
    }
    return 0;
}

static int side_conic(const FT_Vector *b, const FT_Vector *to, void *user)
{
    struct sides *o = user;
    const double a[] = {o->at[0], o->at[1]};
    for (int i = 1; i <= 64; i++) {
        const double t = i / 64.0, u = 1 - t;
        add_side(o,
                 u * u * a[0] +
                     (2 * u * t * (double)b->x + t * t * (double)to->x) / 64,
                 u * u * a[1] +
                     (2 * u * t * (double)b->y + t * t * (double)to->y) / 64);
    }
    return 0;
}

struct crossing {
    double x;
    int way;
};

static int by_x(const void *a, const void *b)
{
    const struct crossing *p = a, *q = b;
    return (p->x > q->x) - (p->x < q->x);
}

/* Adds the length in each pixel of a line to the levels of its row. */
static void add_line(const struct sides *o, double y, int left, int width,
                     double *level)
{
    static struct crossing c[SIDES];
    int n = 0, winding = 0;
    for (int i = 0; i < o->n; i++) {
        const double *a = o->from[i], *b = o->to[i];
        if ((a[1] <= y) != (b[1] <= y))
            c[n++] = (struct crossing){
                a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) - left,
                b[1] > a[1] ? 1 : -1};
    }
    qsort(c, (size_t)n, sizeof *c, by_x);
    for (int i = 0; i + 1 < n; i++) {
        winding += c[i].way;
        for (int x = (int)c[i].x; winding && x < width && x < c[i + 1].x; x++) {
            const double from = c[i].x > x ? c[i].x : x;
            const double to = c[i + 1].x < x + 1 ? c[i + 1].x : x + 1;
            level[x] += (to - from) * 255 / LINES;
        }
    }
}

/* The furthest level of a glyph of 8 bits from its exact area, and in 16 steps.
 */
static void compare_area(const struct font *font, const struct font_char *c,
                         const struct sides *o, double worst[2])
{
    for (int y = 0; y < c->height; y++) {
        double level[256] = {0};
        for (int i = 0; i < LINES; i++)
            add_line(o, c->top - y - (i + .5) / LINES, c->left, c->width,
                     level);
        for (int x = 0; x < c->width; x++) {
            const int got = font->bits[c->offset + (size_t)(y * c->width + x)];
            const int step = (got * 15 + 127) / 255 * 17;
            const double far[] = {fabs(got - level[x]), fabs(step - level[x])};
            for (int k = 0; k < 2; k++)
                worst[k] = far[k] > worst[k] ? far[k] : worst[k];
        }
    }
}

/* Without hinting: at most 2 of 255 at 8 bits, and 10.5 at 4. */
TEST(levels_are_exact_areas)
{
    static const FT_Outline_Funcs functions = {
        side_move, side_line, side_conic, side_cubic, 0, 0};
    FT_Library library;
    double worst[2] = {0, 0};
    assert_int_equal(FT_Init_FreeType(&library), 0);
    for (int i = 0; i < PATHS * SIZES; i++) {
        static struct sides o;
        struct font font;
        FT_Face face;
        const int size = sizes[i % SIZES];
        const struct font_options options = {.size = size,
                                             .bits = 8,
                                             .hinting = FONT_UNHINTED,
                                             .is_wanted = is_sampled};
        wanted_rest = i % 16;
        assert_true(font_load(&font, paths[i / SIZES], &options));
        assert_int_equal(FT_New_Face(library, paths[i / SIZES], 0, &face), 0);
        FT_Size_RequestRec request = {FT_SIZE_REQUEST_TYPE_CELL, 0, size * 64,
                                      0, 0};
        do
            assert_int_equal(FT_Request_Size(face, &request), 0);
        while (face->size->metrics.ascender - face->size->metrics.descender >
                   size * 64 &&
               (request.height -= 16) >= 64);
        for (size_t k = 0; k < font.count; k++) {
            const struct font_char *c = &font.chars[k];
            if (!is_sampled((long)c->code) || c->code > 0x2000)
                continue;
            memset(&o, 0, sizeof o);
            assert_int_equal(FT_Load_Char(face, c->code, FT_LOAD_NO_HINTING),
                             0);
            FT_Outline_Decompose(&face->glyph->outline, &functions, &o);
            add_side(&o, o.begin[0], o.begin[1]);
            compare_area(&font, c, &o, worst);
            if (worst[0] > 2 || worst[1] > 10.5)
                fail_msg("%s, %d px, U+%04lX: %.2f, in 16 steps %.2f of 255",
                         paths[i / SIZES], size, (unsigned long)c->code,
                         worst[0], worst[1]);
        }
        FT_Done_Face(face);
        font_free(&font);
    }
    printf("of exact areas %.2f of 255, in 16 steps %.2f at most\n", worst[0],
           worst[1]);
    FT_Done_FreeType(library);
}
