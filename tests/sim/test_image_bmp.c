/* BMP of every kind, and the pixels that they are by the rules that BMP Suite
 * holds readers to. */
#include "encoded.h"

struct bmp {
    const char *what;
    uint32_t header, bits, compression;
    const char *masks; /* hexadecimal; of the colours too */
    int width, height;
    const char *pixels;
    size_t size;
    const char *colors; /* from the top */
};

static const struct bmp bmps[] = {
    {"1 bit", 40, 1, 0, "", 3, 1, BYTES("\xA0\0\0\0"),
     "FF203040 FF102030 FF203040"},
    {"1 bit of OS/2", 12, 1, 0, "", 3, 1, BYTES("\xA0\0\0\0"),
     "FF203040 FF102030 FF203040"},
    {"2 bits", 40, 2, 0, "", 4, 1, BYTES("\x1B\0\0\0"),
     "FF102030 FF203040 FF304050 FF405060"},
    {"4 bits", 40, 4, 0, "", 3, 1, BYTES("\x01\x20\0\0"),
     "FF102030 FF203040 FF304050"},
    {"8 bits of OS/2 2", 64, 8, 0, "", 2, 2, BYTES("\1\2\0\0\0\3\0\0"),
     "FF102030 FF405060 FF203040 FF304050"},
    {"from the top", 40, 8, 0, "", 2, -2, BYTES("\1\2\0\0\0\3\0\0"),
     "FF203040 FF304050 FF102030 FF405060"},
    {"24 bits", 40, 24, 0, "", 2, 2,
     BYTES("\1\2\3\4\5\6\0\0\7\10\11\12\13\14\0\0"),
     "FF090807 FF0C0B0A FF030201 FF060504"},
    {"16 bits are 1555", 40, 16, 0, "", 2, 1, BYTES("\xFF\x7F\x10\x42"),
     "FFFFFFFF FF848484"},
    {"565", 40, 16, 3, "F800 7E0 1F", 2, 1, BYTES("\xFF\xFF\x10\x84"),
     "FFFFFFFF FF848284"},
    {"565 of V3", 56, 16, 3, "F800 7E0 1F 0", 1, 1, BYTES("\xFF\xFF\0\0"),
     "FFFFFFFF"},
    {"565 of V2", 52, 16, 3, "F800 7E0 1F 0", 1, 1, BYTES("\x1F\0\0\0"),
     "FF0000FF"},
    {"555 turned round", 108, 16, 3, "1F 3E0 7C00 0", 1, 1, BYTES("\x1F\0\0\0"),
     "FFFF0000"},
    {"1555 of V5", 124, 16, 3, "7C00 3E0 1F 8000", 2, 1,
     BYTES("\xFF\x7F\0\x80"), "FFFFFF FF000000"},
    {"444", 40, 16, 3, "F00 F0 F", 2, 1, BYTES("\xFF\x0F\x23\x01"),
     "FFFFFFFF FF112233"},
    {"4444", 56, 16, 3, "F00 F0 F F000", 1, 1, BYTES("\x23\x81\0\0"),
     "88112233"},
    {"655", 40, 16, 3, "FC00 3E0 1F", 2, 1, BYTES("\xFF\xFF\x29\x86"),
     "FFFFFFFF FF868C4A"},
    {"332 in 16", 40, 16, 3, "E0 1C 3", 2, 1, BYTES("\xFF\0\x51\0"),
     "FFFFFFFF FF499255"},
    {"32 bits", 40, 32, 0, "", 1, 1, BYTES("\1\2\3\4"), "FF030201"},
    {"8888 of V4", 108, 32, 3, "FF0000 FF00 FF FF000000", 1, 1,
     BYTES("\1\2\3\4"), "4030201"},
    {"8888 turned round", 108, 32, 3, "FF000000 FF0000 FF00 FF", 1, 1,
     BYTES("\1\2\3\4"), "1040302"},
    {"4 masks behind 40", 40, 32, 6, "FF0000 FF00 FF FF000000", 1, 1,
     BYTES("\1\2\3\4"), "4030201"},
    {"10 bits", 40, 32, 3, "3FF00000 FFC00 3FF", 2, 1,
     BYTES("\x03\x00\xF8\x3F\xFF\xFF\xFF\x3F"), "FFFF8001 FFFFFFFF"},
    {"runs of 8", 40, 8, 1, "", 4, 2, BYTES("\1\1\0\3\0\2\3\0\0\0\4\2\0\1"),
     "FF304050 FF304050 FF304050 FF304050 FF203040 FF102030 FF304050 FF405060"},
    {"runs of 4", 40, 4, 2, "", 5, 1, BYTES("\5\x12\0\1"),
     "FF203040 FF304050 FF203040 FF304050 FF203040"},
    {"indices of 4", 40, 4, 2, "", 5, 1, BYTES("\0\5\x12\x30\x10\0\0\1"),
     "FF203040 FF304050 FF405060 FF102030 FF203040"},
    {"a step", 40, 8, 1, "", 4, 2, BYTES("\0\2\1\1\2\1\0\1"),
     "0 FF203040 FF203040"},
    {"no end", 40, 8, 1, "", 2, 2, BYTES("\2\1\0\0\2\2"),
     "FF304050 FF304050 FF203040 FF203040"},
};

static void add(struct bytes *b, uint32_t value, int n)
{
    for (int i = 0; i < n; i++)
        b->at[b->n++] = (unsigned char)(value >> 8 * i);
}

static void make_bmp(const struct bmp *from, struct bytes *b)
{
    const uint32_t n = from->header == 12 ? 2 : 4;
    const uint32_t masks = from->header >= 52 || from->compression < 3 ? 0
                           : from->compression == 6                    ? 4
                                                                       : 3;
    const uint32_t colors = from->bits > 8       ? 0
                            : from->header == 12 ? 1u << from->bits
                                                 : 4;
    const uint32_t entries = from->bits == 1 && colors > 2 ? 2 : colors;
    const uint32_t rows =
        14 + from->header + 4 * masks + entries * (from->header == 12 ? 3 : 4);
    pel_color mask[4];
    read_colors(from->masks, mask, 4);
    b->n = 0;
    add(b, 0x4D42, 2);
    add(b, rows + (uint32_t)from->size, 4);
    add(b, 0, 4);
    add(b, rows, 4);
    add(b, from->header, 4);
    add(b, (uint32_t)from->width, (int)n);
    add(b, (uint32_t)from->height, (int)n);
    add(b, from->bits << 16 | 1, 4);
    if (n == 4) {
        add(b, from->compression, 4);
        add(b, (uint32_t)from->size, 4);
        add(b, 0, 4);
        add(b, 0, 4);
        add(b, entries, 4);
        add(b, 0, 4);
    }
    for (int k = 0; k < 4 && from->header > 40 && from->compression; k++)
        add(b, mask[k], from->header == 52 && k == 3 ? 0 : 4);
    while (b->n < 14 + from->header)
        add(b, 0, 1);
    for (uint32_t k = 0; k < masks; k++)
        add(b, mask[k], 4);
    for (uint32_t i = 0; i < entries; i++)
        add(b, 0x102030 + 0x101010 * i, n == 2 ? 3 : 4);
    memcpy(b->at + b->n, from->pixels, from->size);
    b->n += from->size;
}

TEST(bmp)
{
    for (size_t i = 0; i < sizeof(bmps) / sizeof(*bmps); i++) {
        const struct bmp *row = &bmps[i];
        struct bytes b;
        pel_color color[8];
        make_bmp(row, &b);
        read_colors(row->colors, color, 8);
        expect(
            &(struct expected){row->what, row->width, abs(row->height), color},
            b.at, b.n);
        for (size_t n = 2; n + 4 < b.n; n++)
            refused("in: ends before its picture does", b.at, n);
    }
}

TEST(bmp_refused)
{
    static const struct bmp wrong[] = {
        {"whose compression is 4", 40, 0, 4, "", 1, 1, BYTES("\0\0\0\0"), ""},
        {"number of bits is 5", 40, 5, 0, "", 1, 1, BYTES("\0\0\0\0"), ""},
        {"whose compression is 1", 40, 4, 1, "", 1, 1, BYTES("\0\1"), ""},
        {"order is from the top", 40, 8, 1, "", 1, -1, BYTES("\0\1"), ""},
        {"whose mask is 160", 40, 16, 3, "A0 1F 700", 1, 1, BYTES("\0\0\0\0"),
         ""},
        {"whose mask is 31", 40, 16, 3, "1F 1F 700", 1, 1, BYTES("\0\0\0\0"),
         ""},
        {"a pixel has colour 4 of 4", 40, 8, 0, "", 1, 1, BYTES("\4\0\0\0"),
         ""},
        {"a run of 3 pixels at 2, 0 leaves", 40, 8, 1, "", 4, 2,
         BYTES("\2\1\0\3\0\2\3\0\0\1"), ""},
        {"a run of 1 pixels at 0, 2 leaves", 40, 8, 1, "", 4, 2,
         BYTES("\0\2\0\2\1\1\0\1"), ""},
        {"0 x 1 pixels", 40, 24, 0, "", 0, 1, BYTES("\4\0\0\0"), ""},
    };
    for (size_t i = 0; i < sizeof(wrong) / sizeof(*wrong); i++) {
        struct bytes b;
        make_bmp(&wrong[i], &b);
        refused(i == 0 ? "number of bits is 0" : wrong[i].what, b.at, b.n);
    }
}

/* The rows of the picture at `at`, and `used` colours in the header, as far as
 * it has that. */
static void make_moved(const struct bmp *from, uint32_t at, uint32_t used,
                       struct bytes *b)
{
    make_bmp(from, b);
    for (int i = 0; i < 4; i++) {
        b->at[10 + i] = (unsigned char)(at >> 8 * i);
        b->at[46 + i] = (unsigned char)(used >> 8 * i);
    }
}

/* Where the header does not count the colours, the rows begin behind them. */
TEST(bmp_palette_before_rows)
{
    static const struct bmp four = {"", 40, 8, 0, "", 1, 1, BYTES("\2\0\0\0"),
                                    ""};
    static const pel_color color[1] = {0xFF304050};
    struct bytes b;
    make_moved(&four, 70, 0, &b);
    expect(&(struct expected){"four colours", 1, 1, color}, b.at, b.n);
    make_moved(&four, 62, 4, &b);
    refused("a pixel has colour 80 of 2", b.at, b.n);
    make_moved(&four, 0, 4, &b);
    refused("whose rows begin at byte 0: expected 54 or more", b.at, b.n);
    make_moved(&four, 53, 4, &b);
    refused("whose rows begin at byte 53: expected 54 or more", b.at, b.n);
}
