/* BDF files: what is read, what is read with which words, and what is refused.
 */
#include "fonts.h"

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

TEST(bdf_errors)
{
    static const struct {
        const char *text, *message;
    } row[] = {
        {"", "is no"},
        {"STARTFON", "is no"},
        {"STARTFONT 2.1\n", "has no glyph"},
        {"STARTFONTS 2.1\n", ":1: 'STARTFONTS': expected STARTFONT"},
        {"STARTFONT 2.1\nFONTBOUNDINGBOX 1 2 3\n", ":2: FONTBOUNDINGBOX is 1"},
        {"STARTFONT 2.1\nFONTBOUNDINGBOX 256 2 3 0\n", "of 0 to 255, and a "
                                                       "place within -255 to"},
        {"STARTFONT 2.1\nFONTBOUNDINGBOX 1 255 0 1\n", "to 255 of the origin"},
        {"STARTFONT 2.1\nFONTBOUNDINGBOX 1 2 0 -256\n", "of the origin"},
        {HEAD "CHARS 0\nENDFONT\n", "has no glyph"},
        {HEAD "CHARS 1\n" CHAR_NONE "ENDFONT\n", "has no glyph"},
        {HEAD "STARTCHAR a\nENCODING 9\nDWIDTH 256 0\n", ":13: DWIDTH is 256"},
        {HEAD "STARTCHAR a\nENCODING 9\nDWIDTH -1 0\n", ":13: DWIDTH is -1"},
        {HEAD "STARTCHAR a\nENCODING 9\n", "the file ends here: expected BITM"},
        {HEAD "STARTCHAR a\nENCODING 9\nBITMAP\n00\n", "expected ENDCHAR"},
        {"STARTFONT 2.1\nSTARTPROPERTIES 1\n", "expected ENDPROPERTIES"},
        {"STARTFONT 2.1\nSTARTPROPERTIES 2\nCHARSET_REGISTRY \"Adobe\"\n"
         "CHARSET_ENCODING \"FontSpecific\"\nENDPROPERTIES\n" CHAR_L,
         "encoded in Adobe-FontSpecific, which iconv does not know: expected "
         "--encoding NAME"},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        check_refused(row[i].text, strlen(row[i].text), row[i].message);
}

/* What is read in spite of a mistake: each L is the one of the right font. */
#define L_OF(advance, box, rows) \
    "STARTCHAR L\nENCODING 76\n" advance box "BITMAP\n" rows
#define BOX "BBX 5 6 0 -2\n"
#define DWIDTH "DWIDTH 6 0\n"
#define ROWS "00\n40\n40\n40\n70\n00\n"
static const struct {
    const char *text, *message;
} mended[] = {
    {HEAD "CHARS 1\n" CHAR_L "ENDFONT\n", ""},
    {HEAD CHAR_L "ENDFONT\n", "1 missing or wrong CHARS\n"},
    {HEAD "CHARS 7\n" CHAR_L "ENDFONT\n", "1 missing or wrong CHARS\n"},
    {HEAD "CHARS many\n" CHAR_L "ENDFONT\n", "1 missing or wrong CHARS"},
    {HEAD "CHARS 1\n" CHAR_L, "spite of: 1 missing ENDFONT\n"},
    {HEAD "CHARS 1\n" L_OF(
         DWIDTH, BOX, "0000\n4000\n40\n40\n70FF\n00\n") "ENDCHAR\nENDFONT\n",
     "3 rows longer or shorter than wide\n"},
    {HEAD "CHARS 1\n" L_OF(DWIDTH, BOX,
                           "0\n4\n4\n40\n7\n00 00\n") "ENDCHAR\nENDFONT\n",
     "5 rows longer or shorter"},
    {HEAD "CHARS 1\n" L_OF(DWIDTH, BOX,
                           "00\n4G\n40\n40\n70\n00\n") "ENDCHAR\nENDFONT\n",
     "1 rows longer or shorter"},
    {HEAD
     "CHARS 1\n" L_OF(DWIDTH, BOX, "00\n40\n40\n40\n70\n") "ENDCHAR\nENDFONT\n",
     "1 glyphs with more or fewer rows than high\n"},
    {HEAD "CHARS 1\n" L_OF(DWIDTH, BOX, ROWS "FF\n") "ENDCHAR\nENDFONT\n",
     "1 glyphs with more or fewer rows"},
    {HEAD "CHARS 1\n" L_OF(DWIDTH, BOX, ROWS) "ENDFONT\n",
     "1 glyphs with more or fewer rows"},
    {HEAD "CHARS 1\n" L_OF(DWIDTH, "", ROWS) "ENDCHAR\nENDFONT\n", ""},
    {HEAD "CHARS 1\n" L_OF("DWIDTH 6 1\n", BOX, ROWS) "ENDCHAR\nENDFONT\n",
     "1 glyphs without DWIDTH, or with one that goes up\n"},
    {HEAD
     "CHARS 1\n" L_OF("DWIDTH 6\nWIDE 6\n", BOX, ROWS) "ENDCHAR\nENDFONT\n",
     "2 lines that are not of the format\n"},
    {HEAD "CHARS 1\n" CHAR_L CHAR_L "ENDFONT\n", "spite of: 1 missing or"},
    {HEAD "CHARS 2\nSTARTCHAR x\nBITMAP\nENDCHAR\n" CHAR_L "ENDFONT\n",
     "1 glyphs without ENCODING, 1 glyphs without DWIDTH, or with one that "
     "goes up, 1 glyphs with more or fewer"},
    {HEAD "nonsense\nCHARS 1\n" CHAR_L "ENDFONT\n", "1 lines that are not"},
    {"STARTFONT 2.1\nFONTBOUNDINGBOX 5 6 0 -2\nSTARTPROPERTIES 2\n"
     "FONT_ASCENT 5\nFONT_DESCENT 2\nCHARS 1\n" CHAR_L "ENDFONT\n",
     "1 lines that are not"},
    {"STARTFONT 2.1\n\tFONTBOUNDINGBOX 5 6 0 -2\nSTARTPROPERTIES 2\n"
     " FONT_ASCENT 5\n FONT_DESCENT 2\nENDPROPERTIES\nCHARS 1\n" CHAR_L
     "ENDFONT\n",
     ""},
};

TEST(bdf_mended)
{
    for (size_t i = 0; i < sizeof mended / sizeof *mended; i++) {
        struct font f;
        struct messages m;
        messages_begin(&m);
        const bool done = load(&f, mended[i].text, strlen(mended[i].text));
        const char *said = messages_end(&m);
        if (!done ||
            (*mended[i].message ? !strstr(said, mended[i].message) : *said))
            fail_msg("row %zu: expected '%s', got '%s'", i, mended[i].message,
                     said);
        const struct font_char *l = &f.chars[0];
        assert_int_equal(f.count, 1);
        assert_int_equal(f.ascent, 5);
        assert_int_equal(f.descent, 2);
        assert_true(l->code == 76 && l->width == 3 && l->left == 1 &&
                    l->top == 3 && l->advance == 6);
        if (i != 7)
            assert_memory_equal(f.bits + l->offset, "\x80\x80\x80\xE0", 4);
        font_free(&f);
    }
}

/* An ascent of 0 is that of the box. */
TEST(bdf_ascent)
{
    struct font f;
    check_told(&f,
               "STARTFONT 2.1\nFONTBOUNDINGBOX 5 6 0 -2\nSTARTPROPERTIES 2\n"
               "FONT_ASCENT 0\nFONT_DESCENT 0\nENDPROPERTIES\nCHARS 1\n" CHAR_L
               "ENDFONT\n",
               "1 FONT_ASCENT of 0\n");
    assert_int_equal(f.ascent, 4);
    font_free(&f);
}

/* 255 px above the baseline and below it, and to its sides. */
TEST(bdf_large)
{
    static const struct {
        const char *box;
        int width, height, left, top;
    } row[] = {{"255 255 0 0", 255, 255, 0, 255},
               {"255 255 -255 -255", 255, 255, -255, 0},
               {"140 140 3 100", 140, 140, 3, 240},
               {"1 255 255 -255", 1, 255, 255, 0}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct font f;
        char *text = NULL;
        size_t size;
        FILE *out = open_memstream(&text, &size);
        assert_non_null(out);
        fprintf(out,
                "STARTFONT 2.1\nCHARS 1\nSTARTCHAR a\nENCODING 97\n"
                "DWIDTH 255 0\nBBX %s\nBITMAP\n",
                row[i].box);
        for (int y = 0; y < row[i].height; y++) {
            for (int x = 0; x < (row[i].width + 7) / 8; x++)
                fputs("FF", out);
            fputc('\n', out);
        }
        fputs("ENDCHAR\nENDFONT\n", out);
        fclose(out);
        check_told(&f, text, "");
        const struct font_char *c = &f.chars[0];
        assert_true(c->width == row[i].width && c->height == row[i].height &&
                    c->left == row[i].left && c->top == row[i].top);
        font_free(&f);
        free(text);
    }
}

/* The characters of codes, as the font says, or as is said for it. */
TEST(encodings)
{
    static const struct {
        const char *registry, *encoding, *wanted;
        int code;
        uint32_t character;
    } row[] = {
        {"ISO10646", "1", NULL, 0x20AC, 0x20AC},
        {"ISO8859", "1", NULL, 0xE9, 0xE9},
        {"iso8859", "2", NULL, 0xE9, 0xE9},
        {"ISO8859", "2", NULL, 0xA3, 0x141},
        {"ISO8859", "5", NULL, 0xD0, 0x430},
        {"ISO8859", "7", NULL, 0xE1, 0x3B1},
        {"ISO8859", "15", NULL, 0xA4, 0x20AC},
        {"KOI8", "R", NULL, 0xC1, 0x430},
        {"US", "ASCII", NULL, 0x41, 0x41},
        {"ISO646.1991", "IRV", NULL, 0x41, 0x41},
        {"JISX0208.1983", "0", NULL, 0x2422, 0x3042},
        {"JISX0201.1976", "0", NULL, 0xB1, 0xFF71},
        {"JISX0212.1990", "0", NULL, 0x2B21, 0xE1},
        {"GB2312.1980", "0", NULL, 0x3021, 0x554A},
        {"KSC5601.1987", "0", NULL, 0x3021, 0xAC00},
        {"Big5", "0", NULL, 0xA440, 0x4E00},
        {"TIS620.2529", "1", NULL, 0xA1, 0xE01},
        {"Microsoft", "CP1251", NULL, 0xE0, 0x430},
        {"Paratype", "PT154", NULL, 0xC0, 0x410},
        {"Adobe", "FontSpecific", "unicode", 0xE9, 0xE9},
        {"Adobe", "FontSpecific", "CP437", 0x82, 0xE9},
        {"ISO8859", "1", "koi8-r", 0xC1, 0x430},
        {"ISO8859", "1", "jisx0208.1983-0", 0x2422, 0x3042},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct font f;
        char text[600];
        snprintf(text, sizeof text,
                 "STARTFONT 2.1\nSTARTPROPERTIES 2\nCHARSET_REGISTRY \"%s\"\n"
                 "CHARSET_ENCODING \"%s\"\nENDPROPERTIES\nCHARS 1\nSTARTCHAR a"
                 "\nENCODING %d\nDWIDTH 2 0\nBBX 1 1 0 0\nBITMAP\n80\nENDCHAR\n"
                 "ENDFONT\n",
                 row[i].registry, row[i].encoding, row[i].code);
        encoding = row[i].wanted;
        check_told(&f, text, "");
        encoding = NULL;
        if (f.chars[0].code != row[i].character)
            fail_msg("row %zu: U+%04X", i, f.chars[0].code);
        font_free(&f);
    }
}

/* Codes that are no character are counted; a font's name tells its encoding
 * where no property does. */
TEST(encoding_lost)
{
    static const char text[] =
        "STARTFONT 2.1\nFONT -a-b-c-d-e--1-2-3-4-f-5-KOI8-R\n"
        "FONTBOUNDINGBOX 1 1 0 0\nCHARS 3\n" CHAR_L
        "STARTCHAR a\nENCODING 193\nDWIDTH 6 0\nBITMAP\n80\nENDCHAR\n"
        "STARTCHAR b\nENCODING 300\nDWIDTH 6 0\nBITMAP\n80\nENDCHAR\n"
        "ENDFONT\n";
    struct font f;
    check_told(&f, text, "1 glyphs are no character of the font's encoding");
    assert_int_equal(f.count, 2);
    assert_int_equal(f.chars[1].code, 0x430);
    font_free(&f);
}

/* Every cut of a right file that lacks a part of a glyph is refused, and
 * nothing is read behind its end. */
TEST(cut_short)
{
    static const char text[] = HEAD "CHARS 1\n" CHAR_L "ENDFONT\n";
    for (size_t n = 0; n + sizeof "ENDFONT\n\n" < sizeof text; n++)
        check_refused(text, n, "");
}
