/* PPM, PGM, PBM and PAM beyond 8 bits of grey and colour, which
 * test_image_picture.c has. */
#include "encoded.h"

/* Samples of any maximum, 1 bit, and alpha. */
TEST(ppm)
{
    static const struct {
        const char *data;
        size_t size;
        int width, height;
        const char *colors; /* hexadecimal */
    } rows[] = {
        {BYTES("P5 3 1 1\n\0\1\1"), 3, 1, "FF000000 FFFFFFFF FFFFFFFF"},
        {BYTES("P5 3 1 4\n\0\1\3"), 3, 1, "FF000000 FF404040 FFBFBFBF"},
        {BYTES("P5 2 1 65535\n\0\x80\0\x81"), 2, 1, "FF000000 FF010101"},
        {BYTES("P5 2 1 256\n\1\0\0\x80"), 2, 1, "FFFFFFFF FF808080"},
        {BYTES("P6 1 1 7\n\0\3\7\n"), 1, 1, "FF006DFF"},
        {BYTES("P6 1 1 65535\n\xFF\xFF\0\0\x12\x34\r\n"), 1, 1, "FFFF0012"},
        {BYTES("P2 3 1 100 # c\n50 33 100\n\n"), 3, 1,
         "FF808080 FF545454 FFFFFFFF"},
        {BYTES("P3 1 1 1023\n1023 512 3"), 1, 1, "FFFF8001"},
        {BYTES("P4 9 1\n\xAA\x80"), 9, 1,
         "FF000000 FFFFFFFF FF000000 FFFFFFFF FF000000 FFFFFFFF FF000000 "
         "FFFFFFFF FF000000"},
        {BYTES("P1\n3 2\n101\n0 1 0\n"), 3, 2,
         "FF000000 FFFFFFFF FF000000 FFFFFFFF FF000000 FFFFFFFF"},
        {BYTES("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\n"
               "TUPLTYPE RGB_ALPHA\nENDHDR\nabc\x80"),
         1, 1, "80616263"},
        {BYTES("P7\n# c\nDEPTH 2\nMAXVAL 15\nHEIGHT 1\nWIDTH 2\nENDHDR\n"
               "\1\2\3\4"),
         2, 1, "22111111 44333333"},
        {BYTES("P7\nWIDTH 2\nHEIGHT 1\nDEPTH 1\nMAXVAL 1\n"
               "TUPLTYPE BLACKANDWHITE\nENDHDR\n\0\1"),
         2, 1, "FF000000 FFFFFFFF"},
        {BYTES("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 3\nMAXVAL 65535\nENDHDR\n"
               "\xFF\xFF\0\x81\0\x80"),
         1, 1, "FFFF0100"},
    };
    for (size_t i = 0; i < sizeof(rows) / sizeof(*rows); i++) {
        char what[16];
        pel_color color[9];
        snprintf(what, sizeof(what), "row %zu", i);
        read_colors(rows[i].colors, color, 9);
        expect(&(struct expected){what, rows[i].width, rows[i].height, color},
               rows[i].data, rows[i].size);
    }
}

TEST(ppm_refused)
{
    refused("the sample is 5: 4 at most", BYTES("P5 1 1 4\n\5"));
    refused("the sample must be 0 or 1", BYTES("P1 2 1\n02"));
    refused("ends in row 1 of 1, 2 bytes a row", BYTES("P4 9 1\n\xAA"));
    refused("ends in row 1 of 1, 2 bytes a row", BYTES("P5 1 1 256\n\1"));
    refused("has 'DEPHT': expected", BYTES("P7\nDEPHT 1\nENDHDR\n"));
    refused("0 x 0 pixels", BYTES("P7\nDEPTH 1\nMAXVAL 1\nENDHDR\n"));
    refused("expected its DEPTH and MAXVAL", BYTES("P7\nWIDTH 1\nENDHDR\n"));
    refused("but there is more", BYTES("P5 1 1 4\n\1\nP5"));
}
