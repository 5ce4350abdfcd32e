/* BDF and PSF files: what is read, and what is refused with which words. */
#include "sim/font/font.h"
#include "tests/support/check.h"

#include "files.h"

/* A font of two glyphs: an L that fills 3 x 4 of its 5 x 6 box, and a space. */
#define HEAD                     \
    "STARTFONT 2.1\n"            \
    "COMMENT made by hand\n"     \
    "FONT -test-\n"              \
    "SIZE 6 75 75\n"             \
    "FONTBOUNDINGBOX 5 6 0 -2\n" \
    "STARTPROPERTIES 3\n"        \
    "FONT_ASCENT 5\n"            \
    "FONT_DESCENT 2\n"           \
    "DEFAULT_CHAR 32\n"          \
    "ENDPROPERTIES\n"
#define CHAR_L                                                           \
    "STARTCHAR L\nENCODING 76\nSWIDTH 500 0\nDWIDTH 6 0\nBBX 5 6 0 -2\n" \
    "BITMAP\n00\n40\n40\n40\n70\n00\nENDCHAR\n"
#define CHAR_SPACE                               \
    "STARTCHAR space\nENCODING 32\nDWIDTH 3 0\n" \
    "BBX 5 6 0 -2\nBITMAP\n00\n00\n00\n00\n00\n00\nENDCHAR\n"
#define CHAR_NONE                                 \
    "STARTCHAR none\nENCODING -1 7\nDWIDTH 3 0\n" \
    "BBX 1 1 0 0\nBITMAP\n80\nENDCHAR\n"

static bool load(struct font *font, const char *bytes, size_t size)
{
    char *path = file_with(bytes, size);
    bool done = font_load(font, path);
    remove(path);
    free(path);
    return done;
}

TEST(bdf)
{
    static const char text[] =
        HEAD "CHARS 3\n" CHAR_L CHAR_NONE "\n" CHAR_SPACE "ENDFONT\n";
    struct font f;
    assert_true(load(&f, text, sizeof text - 1));
    assert_int_equal(f.ascent, 5);
    assert_int_equal(f.descent, 2);
    assert_int_equal(f.missing, 32);
    assert_int_equal(f.count, 2);
    assert_int_equal(f.chars[0].code, 32);
    assert_int_equal(f.chars[0].advance, 3);
    assert_int_equal(f.chars[0].width, 0);
    const struct font_char *l = &f.chars[1];
    assert_int_equal(l->code, 76);
    assert_int_equal(l->advance, 6);
    assert_int_equal(l->width, 3);
    assert_int_equal(l->height, 4);
    assert_int_equal(l->left, 1);
    assert_int_equal(l->top, 3);
    assert_memory_equal(f.bits + l->offset, "\x80\x80\x80\xE0", 4);
    font_free(&f);
}

/* Lines as DOS ends them, and the box and width of the whole font. */
TEST(bdf_defaults)
{
    static const char text[] =
        "STARTFONT 2.2\r\nFONTBOUNDINGBOX 9 2 0 0\r\nDWIDTH 9 0\r\nCHARS 1\r\n"
        "STARTCHAR a\r\nENCODING 97\r\nBITMAP\r\nff80\r\n8080\r\nENDCHAR\r\n"
        "ENDFONT\r\n";
    struct font f;
    assert_true(load(&f, text, sizeof text - 1));
    assert_int_equal(f.ascent, 2);
    assert_int_equal(f.descent, 0);
    assert_int_equal(f.missing, -1);
    assert_int_equal(f.chars[0].width, 9);
    assert_int_equal(f.chars[0].advance, 9);
    assert_memory_equal(f.bits, "\xFF\x80\x80\x80", 4);
    font_free(&f);
}

static void check_refused(const char *bytes, size_t size, const char *message)
{
    struct messages m;
    struct font f;
    messages_begin(&m);
    bool done = load(&f, bytes, size);
    const char *text = messages_end(&m);
    if (done || strncmp(text, "pel: ", 5) != 0 || !strstr(text, message) ||
        !strstr(text, ": expected "))
        fail_msg("expected '%s', got '%s'", message, text);
    assert_true(f.count == 0 && !f.bits && !f.chars);
}

TEST(bdf_errors)
{
    static const struct {
        const char *text, *message;
    } row[] = {
        {"", "is no font"},
        {"STARTFON", "is no font"},
        {"\x1F\x8B\x08", "gzip -d"},
        {"STARTFONT 3.0\n", ":1: 'STARTFONT 3.0'"},
        {"STARTFONT 2.1\n", ":1: the file ends here: expected ENDFONT"},
        {"STARTFONT 2.1\nBITMAP\n", ":2: 'BITMAP' between glyphs"},
        {"STARTFONT 2.1\nCHARS many\n", ":2: 'CHARS many'"},
        {"STARTFONT 2.1\nCHARS 1 2\n", ":2: 'CHARS 1 2': expected"},
        {"STARTFONT 2.1\nFONTBOUNDINGBOX 1 2 3\n", ":2: 'FONTBOUNDINGBOX 1"},
        {"STARTFONT 2.1\nFONTBOUNDINGBOX 256 2 3 0\n", "of 0 to 255"},
        {HEAD "CHARS 2\n" CHAR_L "ENDFONT\n",
         "1 glyphs: expected the 2 that CHARS"},
        {HEAD CHAR_L "ENDFONT\n", "CHARS says"},
        {HEAD "CHARS 2\n" CHAR_L CHAR_L "ENDFONT\n", "two glyphs of U+004C"},
        {HEAD "CHARS 0\nENDFONT\n", "has no glyph"},
        {HEAD "CHARS 1\n" CHAR_NONE "ENDFONT\n", "has no glyph"},
        {HEAD "STARTCHAR a\nBITMAP\n", ":12: the glyph has no ENCODING"},
        {"STARTFONT 2.1\nSTARTCHAR a\nENCODING 9\nBITMAP\n", ":4: the glyph "
                                                             "has no BBX"},
        {HEAD "STARTCHAR a\nENCODING 9\nBITMAP\n", "has no DWIDTH"},
        {HEAD "STARTCHAR a\nENCODING 9\nDWIDTH 256 0\n", ":13: DWIDTH is 256"},
        {HEAD "STARTCHAR a\nENCODING 9\nDWIDTH 6 1\n", "DWIDTH is 6 1"},
        {HEAD "STARTCHAR a\nENCODING 1114112\n", ":12: 'ENCODING 1114112'"},
        {HEAD "STARTCHAR a\nENCODING 9\nWIDE 6\n", ":13: 'WIDE' in a glyph"},
        {HEAD "STARTCHAR a\nENCODING 9\nDWIDTH 6 0\nBBX 9 1 0 0\nBITMAP\n80\n",
         ":16: '80' as row 1 of 1: expected 4 hexadecimal"},
        {HEAD "STARTCHAR a\nENCODING 9\nDWIDTH 6 0\nBITMAP\n8G\n",
         ":15: '8G' as row 1 of 6"},
        {HEAD
         "STARTCHAR a\nENCODING 9\nDWIDTH 6 0\nBITMAP\n00\n00\n00\n00\n00\n"
         "00\n00\nENDCHAR\n",
         ":21: '00' after 6 rows"},
        {"STARTFONT 2.1\nSTARTPROPERTIES 1\nCHARS 1\n", ":3: CHARS among"},
        {"STARTFONT 2.1\nSTARTPROPERTIES 2\nCHARSET_REGISTRY \"KOI8\"\n"
         "CHARSET_ENCODING \"R\"\nENDPROPERTIES\n",
         ":5: the font is encoded in KOI8-R: expected ISO10646-1"},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        check_refused(row[i].text, strlen(row[i].text), row[i].message);
}

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
    assert_true(load(&f, bytes, size));
    assert_int_equal(f.count, 256);
    assert_int_equal(f.ascent + f.descent, 2);
    assert_int_equal(f.chars[65].code, 65);
    assert_int_equal(f.chars[65].width, 2);
    assert_int_equal(f.chars[65].advance, 8);
    assert_int_equal(f.chars[65].top, f.ascent);
    assert_memory_equal(f.bits + f.chars[65].offset, "\x80\xC0", 2);
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
    check_refused(broken, sizeof bytes - 1, "1 to 255 wide");
    broken[29] = 0;
    broken[18] = 1;
    check_refused(broken, sizeof bytes - 1, "ends after");
    check_refused(bytes, 20, "ends after 20 bytes");
    check_refused(bytes, sizeof bytes - 2, "breaks off");
}

/* Every cut of a right file is refused, and nothing is read behind its end. */
TEST(cut_short)
{
    static const char text[] = HEAD "CHARS 1\n" CHAR_L "ENDFONT\n";
    for (size_t n = 0; n + 8 < sizeof text; n++)
        check_refused(text, n, "");
}
