/* Text: UTF-8, glyphs of code points, places and sizes, drawn pictures. */
#include <string.h>

#include "core/image/smooth_glyph.h"
#include "core/image/text_column.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"

/* A font of four glyphs: a box for what is missing, a space, a letter that
 * reaches below the baseline and left of the pen, and a dot. */
static const uint8_t bits[] = {
    0xE0, 0xA0, 0xE0,       /* box */
    0x60, 0x90, 0x60, 0x80, /* letter */
    0x80,                   /* dot */
};

static const struct pel_font_glyph glyphs[] = {
    {0, 3, 3, 0, 3, 4},
    {0, 0, 0, 0, 0, 2},
    {3, 4, 4, -1, 3, 4},
    {7, 1, 1, 1, 1, 3},
};

static const struct pel_font_range ranges[] = {
    {' ', 1, 1}, {'a', 2, 2}, {0x20AC, 1, 3}};

static const struct pel_font_asset font = {
    PEL_FONT_MAGIC, PEL_FONT_VERSION, 4,    2,    3,    4, 0,   sizeof bits,
    ranges,         glyphs,           bits, NULL, NULL, 0, NULL};

static const struct pel_font_glyph *glyph_of(const struct pel_font_asset *from,
                                             uint32_t code)
{
    return pel_glyph_find(&from, code);
}

TEST(check)
{
    static const struct pel_font_range tangled[] = {
        {' ', 1, 1}, {'a', 2, 2}, {'b', 1, 3}};
    static const struct pel_font_range beyond[] = {
        {' ', 1, 1}, {'a', 2, 2}, {'d', 2, 3}};
    struct pel_font_asset f = font;
    assert_int_equal(pel_font_asset_check(&font), PEL_OK);
    assert_int_equal(pel_font_asset_check(NULL), PEL_ERROR_NULL);
    f.magic++;
    assert_int_equal(pel_font_asset_check(&f), PEL_ERROR_RANGE);
    f = font;
    f.version++;
    assert_int_equal(pel_font_asset_check(&f), PEL_ERROR_RANGE);
    f = font;
    f.size--;
    assert_int_equal(pel_font_asset_check(&f), PEL_ERROR_SIZE);
    f = font;
    f.range = tangled;
    assert_int_equal(pel_font_asset_check(&f), PEL_ERROR_SIZE);
    f.range = beyond;
    assert_int_equal(pel_font_asset_check(&f), PEL_ERROR_SIZE);
    f = font;
    f.missing = 4;
    assert_int_equal(pel_font_asset_check(&f), PEL_ERROR_SIZE);
    f.missing = PEL_FONT_NONE;
    assert_int_equal(pel_font_asset_check(&f), PEL_OK);
}

TEST(find)
{
    struct pel_font_asset f = font;
    assert_ptr_equal(glyph_of(&font, ' '), &glyphs[1]);
    assert_ptr_equal(glyph_of(&font, 'a'), &glyphs[2]);
    assert_ptr_equal(glyph_of(&font, 'b'), &glyphs[3]);
    assert_ptr_equal(glyph_of(&font, 0x20AC), &glyphs[3]);
    assert_ptr_equal(glyph_of(&font, 'c'), &glyphs[0]);
    assert_ptr_equal(glyph_of(&font, 0), &glyphs[0]);
    assert_ptr_equal(glyph_of(&font, 0x10FFFF), &glyphs[0]);
    f.missing = PEL_FONT_NONE;
    assert_null(glyph_of(&f, 'c'));
}

/* A chain: the first font that has a character, on one baseline; pairs are of
 * one font's glyphs alone; what no font has is the first one's box, counted. */
TEST(chain)
{
    static const struct pel_font_range more[] = {{'b', 2, 2}};
    struct pel_font_asset second = font, third = font;
    third.range = more;
    third.ranges = 1;
    third.ascent = 3;
    second.next = &third;
    second.ranges = 1; /* the blank alone */
    const struct pel_font_asset *at = &second;
    assert_ptr_equal(pel_glyph_find(&at, 'c'), &glyphs[3]);
    assert_ptr_equal(at, &third);
    at = &second;
    assert_ptr_equal(pel_glyph_find(&at, ' '), &glyphs[1]);
    assert_ptr_equal(at, &second);
    assert_ptr_equal(pel_glyph_find(&at, 'a'), &glyphs[0]);
    assert_ptr_equal(at, &second);
    assert_int_equal(pel_text_missing(&second, "a bc\n\xE2\x82\xAC\xFF"), 3);
    assert_int_equal(pel_text_missing(&font, "ab c"), 1);
    assert_int_equal(pel_text_missing(&font, ""), 0);
}

static int encode(uint32_t code, char *to)
{
    unsigned char *p = (unsigned char *)to;
    int n = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    static const unsigned char lead[] = {0, 0, 0xC0, 0xE0, 0xF0};
    for (int i = n - 1; i > 0; i--, code >>= 6)
        p[i] = (unsigned char)(0x80 | (code & 0x3F));
    p[0] = (unsigned char)(lead[n] | code);
    p[n] = 0;
    return n;
}

TEST(every_code_point)
{
    for (uint32_t code = 1; code <= 0x10FFFF; code++) {
        char text[8];
        const char *next = text;
        int n = encode(code, text);
        uint32_t got = pel_utf8_next(&next);
        if (code >= 0xD800 && code < 0xE000) {
            assert_int_equal(got, 0xFFFD);
        } else if (got != code || next != text + n) {
            fail_msg("U+%04X: got U+%04X, %d bytes", code, got,
                     (int)(next - text));
        }
    }
}

/* How many bytes each step takes; all give U+FFFD. */
TEST(malformed)
{
    static const struct {
        const char *text;
        int steps[5];
    } row[] = {
        {"\x80", {1}},
        {"\xBF\xBF", {1, 1}},
        {"\xC0\x80", {1, 1}},
        {"\xC1\xBF", {1, 1}},
        {"\xC3", {1}},
        {"\xE0\x80\x80", {1, 1, 1}},
        {"\xE0\xA0", {2}},
        {"\xE2\x82", {2}},
        {"\xED\xA0\x80", {1, 1, 1}},
        {"\xF0\x80\x80\x80", {1, 1, 1, 1}},
        {"\xF0\x9F\x98", {3}},
        {"\xF4\x90\x80\x80", {1, 1, 1, 1}},
        {"\xF5\x80", {1, 1}},
        {"\xFE\xFF", {1, 1}},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const char *next = row[i].text;
        for (int k = 0; row[i].steps[k]; k++) {
            const char *start = next;
            if (pel_utf8_next(&next) != 0xFFFD ||
                next - start != row[i].steps[k])
                fail_msg("row %d, step %d: %d bytes", (int)i, k,
                         (int)(next - start));
        }
        assert_int_equal(*next, 0);
    }
    const char *next = "\xC3"
                       "a";
    assert_int_equal(pel_utf8_next(&next), 0xFFFD);
    assert_int_equal(pel_utf8_next(&next), 'a');
}

TEST(measure)
{
    static const struct {
        const char *text;
        int32_t width, height;
    } row[] = {
        {"", 0, 6},
        {"a", 4, 6},
        {"ab a", 13, 6},
        {"a\nbb\n", 6, 18},
        {"\xE2\x82\xAC", 3, 6},
        {"?\xFF", 8, 6},
        {"\n\n\n", 0, 24},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const struct pel_text_size s = pel_text_measure(&font, row[i].text);
        if (s.width != row[i].width || s.height != row[i].height)
            fail_msg("row %d: %d x %d", (int)i, s.width, s.height);
    }
}

static struct hits hits;

/* The picture of a text whose box starts at (1, 1). */
static void check_picture(const char *string, const char *const *picture)
{
    const struct pel_text_block text = {&font, string, 1, 1};
    const struct pel_rect window = {0, 0, (int32_t)strlen(picture[0]), 14};
    hits_open(&hits, &window);
    pel_text(&hits.surface, &text, &hits.paint);
    for (int32_t y = 0; y < window.y1; y++)
        for (int32_t x = 0; x < window.x1; x++)
            if (hits_at(&hits, x, y) != (picture[y][x] == '#'))
                fail_msg("\"%s\": %d, %d is %d", string, x, y,
                         hits_at(&hits, x, y));
}

TEST(pictures)
{
    static const char *const lines[] = {
        "................", "................", ".##....##..###..",
        "#..#..#..#.#.#..", ".##....##..###..", "#.....#.........",
        "................", "................", "................",
        "................", "..#.............", "................",
        "................", "................"};
    check_picture("a aX\nb", lines);
}

/* Every pixel is a square, wherever the text begins and the clip cuts it; each
 * pixel of it is painted once. */
TEST(scaled)
{
    static struct hits small;
    const struct pel_rect window = {-20, -20, 60, 60}, cut = {-7, -3, 41, 38};
    const struct pel_text_block text = {&font,
                                        "ab c\n\xE2\x82\xAC"
                                        "a",
                                        0, 0};
    hits_open(&small, &window);
    pel_text(&small.surface, &text, &small.paint);
    for (int32_t scale = 1; scale < 9; scale++)
        for (int32_t i = 0; i < 81; i++) {
            const struct pel_text_block large = {
                &font, text.string, i % 9 * 3 - 15, i / 9 * 4 - 21};
            hits_open(&hits, &window);
            hits.surface.clip = cut;
            pel_text_scaled(&hits.surface, &large, scale, &hits.paint);
            for (int32_t y = cut.y0; y < cut.y1; y++)
                for (int32_t x = cut.x0; x < cut.x1; x++) {
                    const int32_t u = x - large.x, v = y - large.y;
                    const bool inside =
                        u / scale < window.x1 && v / scale < window.y1;
                    const int expected =
                        u >= 0 && v >= 0 && inside
                            ? hits_at(&small, u / scale, v / scale)
                            : u < 0 && u >= -scale && v >= 0 &&
                                  hits_at(&small, -1, v / scale);
                    if (hits_at(&hits, x, y) != expected)
                        fail_msg("scale %d, place %d: %d, %d", scale, i, x, y);
                }
        }
}

/* Neither a smooth font in the chain nor another scale, nor a place too far. */
TEST(scaled_not)
{
    static const struct {
        int32_t x, y, scale;
        bool is_smooth;
        uint64_t pixels;
    } row[] = {{1, 1, 0, false, 0},
               {1, 1, 1025, false, 0},
               {1, 1, 2, true, 0},
               {65537, 1, 2, false, 0},
               {-65536, 65536, 1024, false, 0},
               {-900, -1924, 1024, false, 60 * 60}};
    const struct pel_rect window = {0, 0, 60, 60};
    struct pel_font_asset second = font, first = font;
    second.kind = &pel_font_smooth;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const struct pel_text_block text = {&first, "a", row[i].x, row[i].y};
        first.next = row[i].is_smooth ? &second : NULL;
        hits_open(&hits, &window);
        pel_text_scaled(&hits.surface, &text, row[i].scale, &hits.paint);
        assert_int_equal(hits.pixels, row[i].pixels);
    }
}

/* The lines of a column, each drawn where it is to stand. */
TEST(column)
{
    static const struct {
        const char *text, *lines;
        int32_t width, height;
    } row[] = {
        {"", "", 0, 6},
        {"a b", "a b", 0, 6},
        {"a b a", "a b a", 15, 6}, /* 4 2 3 2 4 */
        {"a b a", "a b\na", 14, 6},
        {"a b  a", "a b\na", 9, 6},
        {"a b a", "a\nb\na", 4, 6},
        {"a b\na\n", "a b\na\n", 20, 6},
        {"aab", "a\na\nb", 1, 7},
        {"a aaab", "a\naa\nab", 8, 9},
        {" a", "\na", 5, 6},
        {"a ", "a ", 6, 6},
        {"a ", "a", 5, 6},
        {"a  \nb", "a\nb", 7, 6},
        {"a \n", "a\n", 4, 6},
        {"\xE2\x82\xAC\xE2\x82\xAC", "\xE2\x82\xAC\n\xE2\x82\xAC", 5, -6},
    };
    static struct hits expected;
    const struct pel_rect window = {-30, -30, 60, 60};
    for (size_t i = 0; i < 3 * (sizeof row / sizeof *row); i++) {
        const int32_t align = (int32_t)(i % 3);
        const struct pel_text_column column = {
            {&font, row[i / 3].text, 3, 5},
            row[i / 3].width,
            row[i / 3].height == 6 && align ? 0 : row[i / 3].height,
            (enum pel_text_align)align};
        struct pel_text_size size = {0, 0};
        int32_t y = 5;
        char lines[32];
        strcpy(lines, row[i / 3].lines);
        hits_open(&hits, &window);
        hits_open(&expected, &window);
        for (char *line = lines, *end; line; line = end) {
            end = strchr(line, '\n');
            if (end)
                *end++ = '\0';
            const int32_t width = pel_text_measure(&font, line).width;
            const struct pel_text_block text = {
                &font, line, 3 + (column.width - width) * align / 2, y};
            pel_text(&expected.surface, &text, &expected.paint);
            size.width = pel_max(size.width, width);
            y += row[i / 3].height;
            size.height += pel_magnitude(row[i / 3].height);
        }
        const struct pel_text_size got =
            pel_text_column_draw(&hits.surface, &column, &hits.paint);
        if (got.width != size.width || got.height != size.height)
            fail_msg("row %d: %d x %d", (int)i, got.width, got.height);
        for (y = window.y0; y < window.y1; y++)
            for (int32_t x = window.x0; x < window.x1; x++)
                if (hits_at(&hits, x, y) != hits_at(&expected, x, y))
                    fail_msg("row %d: %d, %d", (int)i, x, y);
    }
}

/* No number of lines overflows; a line that is too high is refused. */
TEST(columns_of_many_lines)
{
    static const int32_t heights[] = {-255, 255,       0,        -256,
                                      256,  INT32_MIN, INT32_MAX};
    static char string[1 << 22];
    memset(string, '\n', sizeof string - 1);
    for (size_t i = 0; i < sizeof heights / sizeof *heights; i++) {
        const struct pel_text_column column = {
            {&font, string, 65536, -65536}, 7, heights[i], PEL_TEXT_LEFT};
        const struct pel_text_size size =
            pel_text_column_draw(NULL, &column, NULL);
        assert_int_equal(size.height, i < 2 ? 255 << 22 : i == 2 ? 6 << 22 : 0);
    }
}

/* Any clip and any place: the same pixels, as long as the pen is in range. */
TEST(far_away)
{
    static char string[200000];
    const struct pel_rect window = {0, 0, 100, 8};
    const struct pel_text_block text = {&font, string, -40000, 0};
    memset(string, 'b', sizeof string - 1);
    hits_open(&hits, &window);
    pel_text(&hits.surface, &text, &hits.paint);
    assert_int_equal(hits.pixels, 34);
    assert_int_equal(pel_text_measure(&font, string).width, 599997);
}

/* A dot 255 px above and left of its pen, or as far below and right of it. */
TEST(large_glyphs)
{
    static const struct pel_font_glyph far[] = {{7, 1, 1, -255, 255, 200},
                                                {7, 1, 1, 255, -254, 200}};
    static const struct pel_font_range one[] = {{'a', 2, 0}};
    const struct pel_font_asset large = {PEL_FONT_MAGIC,
                                         PEL_FONT_VERSION,
                                         255,
                                         255,
                                         1,
                                         2,
                                         PEL_FONT_NONE,
                                         sizeof bits,
                                         one,
                                         far,
                                         bits,
                                         NULL,
                                         NULL,
                                         0,
                                         NULL};
    assert_int_equal(pel_font_asset_check(&large), PEL_OK);
    for (int i = 0; i < 2; i++) {
        const int32_t x = i ? 555 : 45, y = i ? 519 : 10;
        const struct pel_rect window = {x - 3, y - 3, x + 4, y + 4};
        const struct pel_text_block text = {&large, i ? "b" : "a", 300, 10};
        hits_open(&hits, &window);
        pel_text(&hits.surface, &text, &hits.paint);
        assert_int_equal(hits.pixels, 1);
        assert_int_equal(hits_at(&hits, x, y), 1);
    }
}
