/* Fonts of outlines: the points of the asset are those that FreeType reads,
 * for TrueType, OpenType and Type 1; damaged files are read or refused. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "files.h"
#include "sim/font/outline_asset.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"

static const char *const paths[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf",
    "/usr/share/fonts/truetype/noto/NotoSansMono-Regular.ttf",
    "/usr/share/fonts/opentype/urw-base35/NimbusRoman-Regular.otf",
    "/usr/share/fonts/opentype/urw-base35/NimbusSans-Bold.otf",
    "/usr/share/fonts/type1/urw-base35/C059-Roman.t1",
};
enum { FONTS = sizeof paths / sizeof *paths, MOST = 4096 };

/* Lines and curves, one number after the other: M, L, Q or C, far apart, and
 * points, in 1/64 of the font's units. */
struct segments {
    int v[MOST], n;
    FT_Vector begin, begins[MOST]; /* of this part, and of all */
    int parts, halves;             /* those that begin on no unit */
    bool is_whole; /* no point is rounded but where a part begins and ends */
};

static void put(struct segments *s, int value)
{
    assert_true(s->n < MOST);
    s->v[s->n++] = value;
}

static int in_units(FT_Pos x)
{
    return (int)((x + 32) >> 6);
}

/* Halves of units are the middles of controls, but where a part begins; parts
 * of composed glyphs that are scaled have any fractions. */
static void put_points(struct segments *s, char verb, const FT_Vector *v, int n)
{
    put(s, verb << 20);
    for (int i = 0; i < n; i++) {
        const bool is_begin = v[i].x == s->begin.x && v[i].y == s->begin.y;
        const int step = verb == 'Q' && i == n - 1 ? 32 : 64;
        s->is_whole &= is_begin || (v[i].x % step == 0 && v[i].y % step == 0);
        put(s, is_begin ? 64 * in_units(v[i].x) : (int)v[i].x);
        put(s, is_begin ? 64 * in_units(v[i].y) : (int)v[i].y);
    }
}

/* A line back to where the part began is none. */
static void end_part(struct segments *s)
{
    if (s->n > 3 && s->v[s->n - 3] == 'L' << 20 &&
        in_units(s->v[s->n - 2]) == in_units(s->begin.x) &&
        in_units(s->v[s->n - 1]) == in_units(s->begin.y))
        s->n -= 3;
}

static int move_to(const FT_Vector *to, void *user)
{
    struct segments *s = user;
    end_part(s);
    s->begin = s->begins[s->parts++] = *to;
    s->halves += to->x % 64 != 0 || to->y % 64 != 0;
    put_points(s, 'M', to, 1);
    return 0;
}

static int line_to(const FT_Vector *to, void *user)
{
    put_points(user, 'L', to, 1);
    return 0;
}

static int conic_to(const FT_Vector *a, const FT_Vector *to, void *user)
{
    const FT_Vector v[] = {*a, *to};
    put_points(user, 'Q', v, 2);
    return 0;
}

static int cubic_to(const FT_Vector *a, const FT_Vector *b, const FT_Vector *to,
                    void *user)
{
    const FT_Vector v[] = {*a, *b, *to};
    put_points(user, 'C', v, 3);
    return 0;
}

static int take(const uint8_t **at, int form)
{
    int move = form ? *(*at)++ : 0;
    if (form == 3)
        move = (int16_t)(move | *(*at)++ << 8);
    return 64 * (form == 2 ? -move : move);
}

/* The bytes of a glyph by the header's words. */
static void decode(struct segments *s, const uint8_t *at, const uint8_t *end)
{
    FT_Vector begin = {0, 0}, p = {0, 0}, wait[3];
    int n = 0;
    while (at < end) {
        const int head = *at++, kind = head & 3;
        const FT_Vector before = p;
        p.x += take(&at, head >> 2 & 3);
        p.y += take(&at, head >> 4 & 3);
        const bool half = kind == PEL_OUTLINE_QUAD && n == 1;
        const bool ends = kind == PEL_OUTLINE_BEGIN && n > 0;
        if (half || ends) {
            wait[n] = begin;
            if (half)
                wait[n] =
                    (FT_Vector){(before.x + p.x) / 2, (before.y + p.y) / 2};
            put_points(s, n == 1 ? 'Q' : 'C', wait, n + 1);
            n = 0;
        }
        if (kind == PEL_OUTLINE_BEGIN) {
            move_to(&p, s);
            begin = p;
        }
        if (kind != PEL_OUTLINE_BEGIN)
            wait[n++] = p;
        if (kind == PEL_OUTLINE_ON) {
            put_points(s, n == 1 ? 'L' : n == 2 ? 'Q' : 'C', wait, n);
            n = 0;
        }
    }
    wait[n] = begin;
    if (n > 0)
        put_points(s, n == 1 ? 'Q' : 'C', wait, n + 1);
    end_part(s);
}

/* Where FreeType begins a part from point a to z. */
static FT_Vector begin_of(const FT_Outline *o, int a, int z)
{
    const FT_Vector *v = o->points;
    if (o->tags[a] & FT_CURVE_TAG_ON)
        return v[a];
    return o->tags[z] & FT_CURVE_TAG_ON
               ? v[z]
               : (FT_Vector){(v[a].x + v[z].x) / 2, (v[a].y + v[z].y) / 2};
}

/* Lets it begin there, if it can. */
static void begin_at(FT_Outline *o, int a, int z, FT_Vector at)
{
    for (int i = a; i <= z; i++) {
        const FT_Vector begin = begin_of(o, a, z);
        if (in_units(begin.x) == in_units(at.x) &&
            in_units(begin.y) == in_units(at.y))
            return;
        for (int k = a; k < z; k++) {
            const FT_Vector v = o->points[k];
            const int tag = o->tags[k];
            o->points[k] = o->points[k + 1];
            o->tags[k] = o->tags[k + 1];
            o->points[k + 1] = v;
            o->tags[k + 1] = (char)tag;
        }
    }
}

/* Parts may begin at any point. */
static void begin_as(FT_Outline *o, const struct segments *asset)
{
    for (int i = 0, a = 0; i < o->n_contours && i < asset->parts; i++) {
        begin_at(o, a, o->contours[i], asset->begins[i]);
        a = o->contours[i] + 1;
    }
}

static bool is_same(const struct segments *asset, const struct segments *font)
{
    const int most = font->is_whole ? 0 : 32;
    bool same = asset->n == font->n;
    for (int i = 0; same && i < font->n; i++)
        same = abs(asset->v[i] - font->v[i]) <= most;
    return same;
}

static void make(struct pel_outline_font_asset *asset, const char *path)
{
    const struct font_options options = {.outline = true};
    struct font font;
    if (!font_load(&font, path, &options))
        fail_msg("%s is not read", path);
    assert_true(outline_add_box(&font));
    assert_true(outline_asset_make(asset, &font, path));
    font_free(&font);
    assert_int_equal(pel_outline_font_asset_check(asset), PEL_OK);
}

static void check_glyphs(const struct pel_outline_font_asset *asset,
                         FT_Face face, const char *path)
{
    static const FT_Outline_Funcs functions = {move_to,  line_to, conic_to,
                                               cubic_to, 0,       0};
    static struct segments here, there;
    int halves = 0;
    for (uint32_t i = 0; i < asset->ranges; i++)
        for (uint32_t k = 0; k < asset->range[i].count; k++) {
            const uint32_t code = asset->range[i].first + k;
            const struct pel_outline_glyph *g =
                &asset->glyph[asset->range[i].glyph + k];
            const uint8_t *at = asset->points + g->offset;
            if (FT_Load_Char(face, code, FT_LOAD_NO_HINTING) != 0 ||
                FT_Get_Char_Index(face, code) == 0)
                continue;
            here.n = here.parts = 0;
            there.n = there.parts = there.halves = 0;
            there.is_whole = strstr(path, ".ttf");
            decode(&here, at, at + g->size);
            begin_as(&face->glyph->outline, &here);
            FT_Outline_Decompose(&face->glyph->outline, &functions, &there);
            end_part(&there);
            halves += there.is_whole ? there.halves : 0;
            if (!is_same(&here, &there) ||
                g->advance != in_units(face->glyph->advance.x))
                fail_msg("%s: U+%04X", path, (unsigned)code);
        }
    if (halves > 4)
        fail_msg("%s: %d parts begin between two units", path, halves);
}

TEST(points_are_those_of_freetype)
{
    FT_Library library;
    FT_Face face;
    assert_int_equal(FT_Init_FreeType(&library), 0);
    for (int i = 0; i < FONTS; i++) {
        struct pel_outline_font_asset asset;
        make(&asset, paths[i]);
        assert_int_equal(FT_New_Face(library, paths[i], 0, &face), 0);
        FT_Set_Pixel_Sizes(face, 0, face->units_per_EM);
        assert_int_equal(asset.em, face->units_per_EM);
        assert_true(asset.glyphs > 200);
        check_glyphs(&asset, face, paths[i]);
        FT_Done_Face(face);
        outline_asset_free(&asset);
    }
    FT_Done_FreeType(library);
}

static bool is_latin(long code)
{
    return code < 127;
}

/* A line of ASCII takes no more flash than issue and manual say. */
TEST(ascii_is_small)
{
    const struct font_options options = {.outline = true,
                                         .is_wanted = is_latin};
    struct pel_outline_font_asset asset;
    struct font font;
    assert_true(font_load(&font, paths[0], &options));
    assert_true(outline_asset_make(&asset, &font, paths[0]));
    assert_int_equal(asset.glyphs, 95);
    assert_in_range(asset.size + asset.glyphs * sizeof *asset.glyph, 5000,
                    6600);
    font_free(&font);
    outline_asset_free(&asset);
}

static char *read_font(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    char *bytes = malloc(1 << 20);
    *size = fread(bytes, 1, (size_t)1 << 20, file);
    fclose(file);
    return bytes;
}

TEST(damaged_files_are_read_or_refused)
{
    for (struct cases c = cases_of(120); cases_next(&c);) {
        struct random *const r = &c.random;
        const struct font_options options = {.outline = true,
                                             .is_wanted = is_latin};
        struct messages m;
        struct font font;
        size_t size;
        char *bytes = read_font(paths[random_word(r) % FONTS], &size);
        for (int n = random_between(r, 1, 200); n > 0; n--)
            bytes[random_word(r) % size] = (char)random_word(r);
        if (random_word(r) % 8 == 0)
            size = random_word(r) % size;
        char *path = file_with(bytes, size);
        messages_begin(&m);
        const bool done = font_load(&font, path, &options);
        const char *said = messages_end(&m);
        if (strstr(said, "crashed"))
            fail_msg("%s: %s", cases_replay(), said);
        if (done) {
            struct pel_outline_font_asset asset;
            assert_true(outline_add_box(&font));
            assert_true(outline_asset_make(&asset, &font, path));
            assert_int_equal(pel_outline_font_asset_check(&asset), PEL_OK);
            outline_asset_free(&asset);
        }
        font_free(&font);
        remove(path);
        free(path);
        free(bytes);
    }
}
