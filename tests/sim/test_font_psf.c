/* PSF files: what is read, what is read with which words, and what is refused.
 */
#include "fonts.h"

/* Version 1: 256 glyphs of 8 x 2; glyph 65 is a corner. */
static size_t make_psf1(char *to, int mode)
{
    memset(to, 0, 4 + 512);
    memcpy(to, "\x36\x04", 2);
    to[2] = (char)mode;
    to[3] = 2;
    memcpy(to + 4 + 2 * 65, "\x80\xC0", 2);
    return 4 + 512;
}

TEST(psf1)
{
    char bytes[2000];
    struct font f;
    size_t size = make_psf1(bytes, 0);
    memcpy(bytes + 4 + 2 * 0x82, "\x55\x00", 2);
    struct messages m;
    messages_begin(&m);
    assert_true(load(&f, bytes, size));
    assert_non_null(strstr(messages_end(&m), "is read as CP437: --encoding"));
    assert_int_equal(f.count, 256);
    assert_int_equal(f.ascent + f.descent, 2);
    assert_int_equal(f.chars[65].code, 65);
    assert_int_equal(f.chars[65].width, 2);
    assert_int_equal(f.chars[65].advance, 8);
    assert_int_equal(f.chars[65].top, f.ascent);
    assert_memory_equal(f.bits + f.chars[65].offset, "\x80\xC0", 2);
    size_t i = 0;
    while (i < f.count && f.chars[i].code != 0xE9)
        i++;
    assert_true(i < f.count); /* e with an acute accent */
    assert_memory_equal(f.bits + f.chars[i].offset, "\xAA", 1);
    font_free(&f);
    encoding = "iso8859-1";
    messages_begin(&m);
    assert_true(load(&f, bytes, size));
    assert_string_equal(messages_end(&m), "");
    encoding = NULL;
    assert_int_equal(f.chars[0x82].code, 0x82);
    assert_int_equal(f.chars[0x82].width, 7);
    font_free(&f);
}

/* Glyph 65 is A, U+0391 and a sequence; the others have no code point. */
TEST(psf1_table)
{
    char bytes[2000];
    struct font f;
    size_t size = make_psf1(bytes, 2);
    for (int i = 0; i < 256; i++) {
        if (i == 65) {
            memcpy(bytes + size,
                   "A\0\x91\x03\xFE\xFF"
                   "B\0C\0",
                   10);
            size += 10;
        }
        memcpy(bytes + size, "\xFF\xFF", 2);
        size += 2;
    }
    assert_true(load(&f, bytes, size));
    assert_int_equal(f.count, 2);
    assert_int_equal(f.chars[0].code, 'A');
    assert_int_equal(f.chars[1].code, 0x391);
    assert_int_equal(f.chars[1].width, 2);
    font_free(&f);
    check_refused(bytes, size - 1, "breaks off");
    check_refused(bytes, 300, "ends after 300 bytes");
}

/* Version 2: two glyphs of 9 x 1, with a table in UTF-8. */
TEST(psf2)
{
    static const char bytes[] =
        "\x72\xB5\x4A\x86\0\0\0\0\x20\0\0\0\1\0\0\0\2\0\0\0\2\0\0\0\1\0\0\0"
        "\x09\0\0\0\xFF\x80\x00\x80"
        "a\xFF\xE2\x82\xAC\xFE"
        "xy\xFF";
    struct font f;
    char broken[sizeof bytes];
    assert_true(load(&f, bytes, sizeof bytes - 1));
    assert_int_equal(f.count, 2);
    assert_int_equal(f.chars[0].code, 'a');
    assert_int_equal(f.chars[0].width, 9);
    assert_int_equal(f.chars[1].code, 0x20AC);
    assert_int_equal(f.chars[1].left, 8);
    font_free(&f);
    memcpy(broken, bytes, sizeof bytes);
    broken[20] = 3;
    check_refused(broken, sizeof bytes - 1, "of 3 bytes: expected 2 bytes");
    broken[20] = 2;
    broken[4] = 1;
    check_refused(broken, sizeof bytes - 1, "header of version 1");
    broken[4] = 0;
    broken[29] = 1;
    check_refused(broken, sizeof bytes - 1, "1 to 255 wide and high");
    broken[29] = 0;
    broken[18] = 1;
    check_refused(broken, sizeof bytes - 1, "ends after");
    check_refused(bytes, 20, "ends after 20 bytes");
    check_refused(bytes, sizeof bytes - 2, "breaks off");
}
