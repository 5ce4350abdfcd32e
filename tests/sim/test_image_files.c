/* Picture files of every kind, written here, and the pixels that they are: what
 * PngSuite and BMP Suite hold readers to. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifdef HAVE_LIBPNG
#include <png.h>
#endif
#ifdef HAVE_LIBJPEG
#include <jpeglib.h>
#endif

#include "sim/image/texture.h"
#include "files.h"

static bool load(struct picture *picture, const void *bytes, size_t size,
                 struct messages *m)
{
    messages_begin(m);
    const bool done = texture_load_bytes(picture, "in", bytes, size);
    messages_end(m);
    return done;
}

/* The file is a picture of these pixels. */
static void expect(const char *what, const void *bytes, size_t size, int width,
                   int height, const pel_color *color)
{
    struct messages m;
    struct picture p;
    if (!load(&p, bytes, size, &m))
        fail_msg("%s: %s", what, m.text);
    if (p.width != width || p.height != height)
        fail_msg("%s: %d x %d pixels", what, p.width, p.height);
    for (int i = 0; i < width * height; i++)
        if (p.pixels[i] != color[i])
            fail_msg("%s: pixel %d is %08x, not %08x", what, i,
                     (unsigned)p.pixels[i], (unsigned)color[i]);
    picture_free(&p);
}

static void refused(const char *text, const void *bytes, size_t size)
{
    struct messages m;
    struct picture p;
    if (load(&p, bytes, size, &m))
        fail_msg("read, not refused: %s", text);
    if (!strstr(m.text, text))
        fail_msg("not '%s': %s", text, m.text);
}

/* A file in memory. */
struct bytes {
    unsigned char at[4096];
    size_t n;
};

static void add(struct bytes *b, uint32_t value, int n)
{
    for (int i = 0; i < n; i++)
        b->at[b->n++] = (unsigned char)(value >> 8 * i);
}

#ifdef HAVE_LIBPNG

enum { SIDE = 9 };

static void append(png_structp png, png_bytep from, size_t n)
{
    struct bytes *b = png_get_io_ptr(png);
    assert_true(b->n + n <= sizeof(b->at));
    memcpy(b->at + b->n, from, n);
    b->n += n;
}

struct png_kind {
    int type, bits;
    bool interlaced, has_clear; /* one colour is clear, by tRNS */
};

static int channels_of(int type)
{
    return type == PNG_COLOR_TYPE_RGB          ? 3
           : type == PNG_COLOR_TYPE_RGB_ALPHA  ? 4
           : type == PNG_COLOR_TYPE_GRAY_ALPHA ? 2
                                               : 1;
}

/* Channel k of a pixel: every sample up to 8 bits, and those of 16 where
 * rounding turns. */
static unsigned sample(const struct png_kind *kind, int i, int k)
{
    static const unsigned turns[] = {0,     128,   129,   385,   386,  32767,
                                     32896, 65406, 65407, 65535, 4660, 22136};
    if (kind->bits == 16)
        return turns[(i * 5 + k * 3) % 12];
    return (unsigned)(i * 7 + k * 29) & ((1u << kind->bits) - 1);
}

static unsigned as_byte(const struct png_kind *kind, unsigned v)
{
    const unsigned most = (1u << kind->bits) - 1;
    return (v * 510 + most) / (2 * most);
}

static pel_color entry(unsigned i)
{
    return PEL_RGBA(i & 255, (255 - i) & 255, i * 37 & 255,
                    i % 3 == 0 ? i * 11 & 255 : 255);
}

static pel_color png_pixel(const struct png_kind *kind, int i)
{
    const int channels = channels_of(kind->type);
    unsigned v[4] = {0, 0, 0, 0}, raw[4] = {0, 0, 0, 0};
    bool clear = kind->has_clear;
    for (int k = 0; k < channels; k++) {
        raw[k] = sample(kind, i, k);
        v[k] = as_byte(kind, raw[k]);
        clear = clear && raw[k] == sample(kind, 4, k);
    }
    if (kind->type == PNG_COLOR_TYPE_PALETTE)
        return kind->has_clear ? entry(raw[0])
                               : entry(raw[0]) | PEL_RGB(0, 0, 0);
    const unsigned alpha = clear               ? 0
                           : channels % 2 == 0 ? v[channels - 1]
                                               : 255;
    return channels < 3 ? PEL_RGBA(v[0], v[0], v[0], alpha)
                        : PEL_RGBA(v[0], v[1], v[2], alpha);
}

static void set_clear(png_structp png, png_infop info,
                      const struct png_kind *kind)
{
    png_color_16 clear = {0, 0, 0, 0, 0};
    png_byte alpha[256];
    for (unsigned i = 0; i < 256; i++)
        alpha[i] = (png_byte)pel_alpha(entry(i));
    clear.gray = clear.red = (png_uint_16)sample(kind, 4, 0);
    clear.green = (png_uint_16)sample(kind, 4, 1);
    clear.blue = (png_uint_16)sample(kind, 4, 2);
    if (kind->has_clear)
        png_set_tRNS(png, info, alpha, 1 << (kind->bits & 15), &clear);
}

static void set_row(const struct png_kind *kind, int y, unsigned char *row)
{
    const int channels = channels_of(kind->type);
    for (int x = 0; x < SIDE; x++)
        for (int k = 0; k < channels; k++) {
            const unsigned v = sample(kind, y * SIDE + x, k);
            const int bit = (x * channels + k) * kind->bits;
            if (kind->bits == 16)
                row[bit / 8 + 1] = (unsigned char)v;
            row[bit / 8] |=
                (unsigned char)(kind->bits == 16
                                    ? v >> 8
                                    : v << (8 - kind->bits - bit % 8));
        }
}

static void make_png(const struct png_kind *kind, struct bytes *b)
{
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_color palette[256];
    b->n = 0;
    for (unsigned i = 0; i < 256; i++) {
        palette[i].red = (png_byte)pel_red(entry(i));
        palette[i].green = (png_byte)pel_green(entry(i));
        palette[i].blue = (png_byte)pel_blue(entry(i));
    }
    png_set_write_fn(png, b, append, NULL);
    png_set_IHDR(png, info, SIDE, SIDE, kind->bits, kind->type,
                 kind->interlaced, 0, 0);
    if (kind->type == PNG_COLOR_TYPE_PALETTE)
        png_set_PLTE(png, info, palette, 1 << kind->bits);
    set_clear(png, info, kind);
    png_set_gAMA(png, info, 1.0);
    png_write_info(png, info);
    for (int pass = png_set_interlace_handling(png); pass > 0; pass--)
        for (int y = 0; y < SIDE; y++) {
            unsigned char row[SIDE * 8] = {0};
            set_row(kind, y, row);
            png_write_row(png, row);
        }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
}

/* Every colour type at every depth, with and without a clear colour, in rows
 * and in Adam's seven passes; gamma changes nothing. */
TEST(png)
{
    static const int types[] = {
        PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_PALETTE,
        PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB_ALPHA};
    for (int i = 0; i < 5 * 5 * 4; i++) {
        const struct png_kind kind = {types[i % 5], 1 << i / 5 % 5,
                                      i / 25 % 2 == 1, i / 50 == 1};
        const bool palette = kind.type == PNG_COLOR_TYPE_PALETTE;
        pel_color color[SIDE * SIDE];
        struct bytes b;
        char what[80];
        if ((kind.bits < 8 && kind.type != PNG_COLOR_TYPE_GRAY && !palette) ||
            (kind.bits == 16 && palette) ||
            (kind.has_clear && channels_of(kind.type) % 2 == 0))
            continue;
        make_png(&kind, &b);
        for (int k = 0; k < SIDE * SIDE; k++)
            color[k] = png_pixel(&kind, k);
        snprintf(what, sizeof(what), "type %d, %d bits, %d %d", kind.type,
                 kind.bits, kind.interlaced, kind.has_clear);
        expect(what, b.at, b.n, SIDE, SIDE, color);
    }
}

/* Every file that is cut short is refused, and every one with a wrong byte that
 * a checksum covers. */
TEST(png_damaged)
{
    const struct png_kind kind = {PNG_COLOR_TYPE_GRAY, 2, false, true};
    struct bytes b;
    make_png(&kind, &b);
    for (size_t n = 8; n < b.n; n += 3)
        refused("in: ends before its picture does", b.at, n);
    for (size_t i = 16; i < b.n - 12; i += 5) {
        b.at[i] ^= 0x10;
        refused("in: ", b.at, b.n);
        b.at[i] ^= 0x10;
    }
}
#endif

#ifdef HAVE_LIBJPEG

/* Blocks of 16 x 16 pixels of one colour: 2 wide, 3 high. */
static const unsigned char blocks[6][3] = {{255, 0, 0},     {0, 255, 0},
                                           {0, 0, 255},     {255, 255, 0},
                                           {255, 255, 255}, {0, 0, 0}};

/* Of `components` colours a pixel, with an EXIF block that is for "MM" or "II";
 * 0: none. */
static unsigned char *make_jpeg(J_COLOR_SPACE in, J_COLOR_SPACE out, bool adobe,
                                const char *order, int orientation,
                                unsigned long *size)
{
    struct jpeg_compress_struct jpeg;
    struct jpeg_error_mgr error;
    unsigned char *bytes = NULL, row[32 * 4], *rows = row;
    const int n = in == JCS_CMYK ? 4 : 3;
    jpeg.err = jpeg_std_error(&error);
    jpeg_create_compress(&jpeg);
    jpeg_mem_dest(&jpeg, &bytes, size);
    jpeg.image_width = 32;
    jpeg.image_height = 48;
    jpeg.input_components = n;
    jpeg.in_color_space = in;
    jpeg_set_defaults(&jpeg);
    jpeg_set_colorspace(&jpeg, out);
    jpeg_set_quality(&jpeg, 100, TRUE);
    jpeg.write_Adobe_marker = adobe;
    jpeg_start_compress(&jpeg, TRUE);
    if (order) {
        const bool high = order[0] == 'M';
        unsigned char exif[] = {'E', 'x', 'i', 'f', 0, 0,    'I', 'I', 42, 0, 8,
                                0,   0,   0,   1,   0, 0x12, 1,   3,   0,  1, 0,
                                0,   0,   0,   0,   0, 0,    0,   0,   0,  0};
        unsigned char big[] = {'E', 'x', 'i', 'f', 0, 0, 'M',  'M', 0, 42, 0,
                               0,   0,   8,   0,   1, 1, 0x12, 0,   3, 0,  0,
                               0,   1,   0,   0,   0, 0, 0,    0,   0, 0};
        exif[24] = big[25] = (unsigned char)orientation;
        jpeg_write_marker(&jpeg, JPEG_APP0 + 1, high ? big : exif,
                          sizeof(exif));
    }
    while (jpeg.next_scanline < jpeg.image_height) {
        for (int x = 0; x < 32; x++)
            for (int k = 0; k < n; k++) {
                const unsigned y = jpeg.next_scanline / 16;
                const unsigned char *c = blocks[y * 2 + (unsigned)x / 16];
                const unsigned char v = k < 3 ? c[k] : 255;
                row[x * n + k] =
                    (unsigned char)(n == 4 && !adobe ? 255 - v : v);
            }
        jpeg_write_scanlines(&jpeg, &rows, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    return bytes;
}

/* Six letters, the blocks in the order in which they are seen. */
static void expect_blocks(const char *what, const char *seen, int across,
                          const unsigned char *bytes, unsigned long size)
{
    struct messages m;
    struct picture p;
    if (!load(&p, bytes, size, &m))
        fail_msg("%s: %s", what, m.text);
    assert_int_equal(p.width, across * 16);
    assert_int_equal(p.height, 96 / across);
    for (int i = 0; i < 6; i++) {
        const unsigned char *c = blocks[seen[i] - 'a'];
        const pel_color got =
            picture_row(&p, i / across * 16 + 8)[i % across * 16 + 8];
        if (abs((int)pel_red(got) - c[0]) > 2 ||
            abs((int)pel_green(got) - c[1]) > 2 ||
            abs((int)pel_blue(got) - c[2]) > 2 || pel_alpha(got) != 255)
            fail_msg("%s: block %d is %08x", what, i, (unsigned)got);
    }
    picture_free(&p);
}

TEST(jpeg_upright)
{
    static const char *const seen[] = {"abcdef", "abcdef", "badcfe", "fedcba",
                                       "efcdab", "acebdf", "ecafdb", "fdbeca",
                                       "bdface", "abcdef"};
    for (int i = 0; i < 20; i++) {
        const int orientation = i / 2;
        unsigned long size;
        char what[40];
        unsigned char *bytes = make_jpeg(
            JCS_RGB, JCS_YCbCr, false, i % 2 ? "MM" : "II", orientation, &size);
        snprintf(what, sizeof(what), "orientation %d, %d", orientation, i % 2);
        expect_blocks(what, seen[orientation],
                      orientation >= 5 && orientation <= 8 ? 3 : 2, bytes,
                      size);
        free(bytes);
    }
}

/* Ink as Adobe's programs write it, upside down, and as nobody else. */
TEST(jpeg_ink)
{
    unsigned long size;
    unsigned char *bytes = make_jpeg(JCS_CMYK, JCS_CMYK, true, NULL, 0, &size);
    expect_blocks("CMYK of Adobe", "abcdef", 2, bytes, size);
    free(bytes);
    bytes = make_jpeg(JCS_CMYK, JCS_YCCK, true, NULL, 0, &size);
    expect_blocks("YCCK of Adobe", "abcdef", 2, bytes, size);
    free(bytes);
    bytes = make_jpeg(JCS_CMYK, JCS_CMYK, false, NULL, 0, &size);
    expect_blocks("CMYK", "abcdef", 2, bytes, size);
    free(bytes);
    bytes = make_jpeg(JCS_RGB, JCS_RGB, true, NULL, 0, &size);
    expect_blocks("RGB", "abcdef", 2, bytes, size);
    for (unsigned long n = 4; n < size - 2; n += 31)
        refused("in: ", bytes, n);
    free(bytes);
}
#endif

struct bmp {
    const char *what;
    uint32_t header, bits, compression, mask[4];
    int width, height;
    const char *pixels;
    size_t size;
    pel_color color[8]; /* from the top */
};

#define BYTES(text) text, sizeof(text) - 1

static const struct bmp bmps[] = {
    {"1 bit",
     40,
     1,
     0,
     {0},
     3,
     1,
     BYTES("\xA0\0\0\0"),
     {0xFF203040, 0xFF102030, 0xFF203040}},
    {"1 bit of OS/2",
     12,
     1,
     0,
     {0},
     3,
     1,
     BYTES("\xA0\0\0\0"),
     {0xFF203040, 0xFF102030, 0xFF203040}},
    {"2 bits",
     40,
     2,
     0,
     {0},
     4,
     1,
     BYTES("\x1B\0\0\0"),
     {0xFF102030, 0xFF203040, 0xFF304050, 0xFF405060}},
    {"4 bits",
     40,
     4,
     0,
     {0},
     3,
     1,
     BYTES("\x01\x20\0\0"),
     {0xFF102030, 0xFF203040, 0xFF304050}},
    {"8 bits of OS/2 2",
     64,
     8,
     0,
     {0},
     2,
     2,
     BYTES("\1\2\0\0\0\3\0\0"),
     {0xFF102030, 0xFF405060, 0xFF203040, 0xFF304050}},
    {"from the top",
     40,
     8,
     0,
     {0},
     2,
     -2,
     BYTES("\1\2\0\0\0\3\0\0"),
     {0xFF203040, 0xFF304050, 0xFF102030, 0xFF405060}},
    {"24 bits",
     40,
     24,
     0,
     {0},
     2,
     2,
     BYTES("\1\2\3\4\5\6\0\0\7\10\11\12\13\14\0\0"),
     {0xFF090807, 0xFF0C0B0A, 0xFF030201, 0xFF060504}},
    {"16 bits are 1555",
     40,
     16,
     0,
     {0},
     2,
     1,
     BYTES("\xFF\x7F\x10\x42"),
     {0xFFFFFFFF, 0xFF848484}},
    {"565",
     40,
     16,
     3,
     {0xF800, 0x7E0, 0x1F},
     2,
     1,
     BYTES("\xFF\xFF\x10\x84"),
     {0xFFFFFFFF, 0xFF848284}},
    {"565 of V3",
     56,
     16,
     3,
     {0xF800, 0x7E0, 0x1F, 0},
     1,
     1,
     BYTES("\xFF\xFF\0\0"),
     {0xFFFFFFFF}},
    {"565 of V2",
     52,
     16,
     3,
     {0xF800, 0x7E0, 0x1F, 0},
     1,
     1,
     BYTES("\x1F\0\0\0"),
     {0xFF0000FF}},
    {"555 turned round",
     108,
     16,
     3,
     {0x1F, 0x3E0, 0x7C00, 0},
     1,
     1,
     BYTES("\x1F\0\0\0"),
     {0xFFFF0000}},
    {"1555 of V5",
     124,
     16,
     3,
     {0x7C00, 0x3E0, 0x1F, 0x8000},
     2,
     1,
     BYTES("\xFF\x7F\0\x80"),
     {0x00FFFFFF, 0xFF000000}},
    {"444",
     40,
     16,
     3,
     {0xF00, 0xF0, 0xF},
     2,
     1,
     BYTES("\xFF\x0F\x23\x01"),
     {0xFFFFFFFF, 0xFF112233}},
    {"4444",
     56,
     16,
     3,
     {0xF00, 0xF0, 0xF, 0xF000},
     1,
     1,
     BYTES("\x23\x81\0\0"),
     {0x88112233}},
    {"655",
     40,
     16,
     3,
     {0xFC00, 0x3E0, 0x1F},
     2,
     1,
     BYTES("\xFF\xFF\x29\x86"),
     {0xFFFFFFFF, 0xFF868C4A}},
    {"332 in 16",
     40,
     16,
     3,
     {0xE0, 0x1C, 3},
     2,
     1,
     BYTES("\xFF\0\x51\0"),
     {0xFFFFFFFF, 0xFF499255}},
    {"32 bits", 40, 32, 0, {0}, 1, 1, BYTES("\1\2\3\4"), {0xFF030201}},
    {"8888 of V4",
     108,
     32,
     3,
     {0xFF0000, 0xFF00, 0xFF, 0xFF000000},
     1,
     1,
     BYTES("\1\2\3\4"),
     {0x04030201}},
    {"8888 turned round",
     108,
     32,
     3,
     {0xFF000000, 0xFF0000, 0xFF00, 0xFF},
     1,
     1,
     BYTES("\1\2\3\4"),
     {0x01040302}},
    {"4 masks behind 40",
     40,
     32,
     6,
     {0xFF0000, 0xFF00, 0xFF, 0xFF000000},
     1,
     1,
     BYTES("\1\2\3\4"),
     {0x04030201}},
    {"10 bits",
     40,
     32,
     3,
     {0x3FF00000, 0xFFC00, 0x3FF},
     2,
     1,
     BYTES("\x03\x00\xF8\x3F\xFF\xFF\xFF\x3F"),
     {0xFFFF8001, 0xFFFFFFFF}},
    {"runs of 8",
     40,
     8,
     1,
     {0},
     4,
     2,
     BYTES("\1\1\0\3\0\2\3\0\0\0\4\2\0\1"),
     {0xFF304050, 0xFF304050, 0xFF304050, 0xFF304050, 0xFF203040, 0xFF102030,
      0xFF304050, 0xFF405060}},
    {"runs of 4",
     40,
     4,
     2,
     {0},
     5,
     1,
     BYTES("\5\x12\0\1"),
     {0xFF203040, 0xFF304050, 0xFF203040, 0xFF304050, 0xFF203040}},
    {"indices of 4",
     40,
     4,
     2,
     {0},
     5,
     1,
     BYTES("\0\5\x12\x30\x10\0\0\1"),
     {0xFF203040, 0xFF304050, 0xFF405060, 0xFF102030, 0xFF203040}},
    {"a step",
     40,
     8,
     1,
     {0},
     4,
     2,
     BYTES("\0\2\1\1\2\1\0\1"),
     {0, 0xFF203040, 0xFF203040}},
    {"no end",
     40,
     8,
     1,
     {0},
     2,
     2,
     BYTES("\2\1\0\0\2\2"),
     {0xFF304050, 0xFF304050, 0xFF203040, 0xFF203040}},
};

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
        add(b, from->mask[k], from->header == 52 && k == 3 ? 0 : 4);
    while (b->n < 14 + from->header)
        add(b, 0, 1);
    for (uint32_t k = 0; k < masks; k++)
        add(b, from->mask[k], 4);
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
        make_bmp(row, &b);
        expect(row->what, b.at, b.n, row->width, abs(row->height), row->color);
        for (size_t n = 2; n + 4 < b.n; n++)
            refused("in: ends before its picture does", b.at, n);
    }
}

TEST(bmp_refused)
{
    static const struct bmp wrong[] = {
        {"whose compression is 4", 40, 0, 4, {0}, 1, 1, BYTES("\0\0\0\0"), {0}},
        {"number of bits is 5", 40, 5, 0, {0}, 1, 1, BYTES("\0\0\0\0"), {0}},
        {"whose compression is 1", 40, 4, 1, {0}, 1, 1, BYTES("\0\1"), {0}},
        {"order is from the top", 40, 8, 1, {0}, 1, -1, BYTES("\0\1"), {0}},
        {"whose mask is 160",
         40,
         16,
         3,
         {0xA0, 0x1F, 0x700},
         1,
         1,
         BYTES("\0\0\0\0"),
         {0}},
        {"whose mask is 31",
         40,
         16,
         3,
         {0x1F, 0x1F, 0x700},
         1,
         1,
         BYTES("\0\0\0\0"),
         {0}},
        {"a pixel has colour 4 of 4",
         40,
         8,
         0,
         {0},
         1,
         1,
         BYTES("\4\0\0\0"),
         {0}},
        {"a run of 3 pixels at 2, 0 leaves",
         40,
         8,
         1,
         {0},
         4,
         2,
         BYTES("\2\1\0\3\0\2\3\0\0\1"),
         {0}},
        {"a run of 1 pixels at 0, 2 leaves",
         40,
         8,
         1,
         {0},
         4,
         2,
         BYTES("\0\2\0\2\1\1\0\1"),
         {0}},
        {"0 x 1 pixels", 40, 24, 0, {0}, 0, 1, BYTES("\4\0\0\0"), {0}},
    };
    for (size_t i = 0; i < sizeof(wrong) / sizeof(*wrong); i++) {
        struct bytes b;
        make_bmp(&wrong[i], &b);
        refused(i == 0 ? "number of bits is 0" : wrong[i].what, b.at, b.n);
    }
}

/* Samples of any maximum, 1 bit, and alpha. */
TEST(ppm)
{
    static const struct {
        const char *data;
        size_t size;
        int width, height;
        pel_color color[9];
    } rows[] = {
        {BYTES("P5 3 1 1\n\0\1\1"), 3, 1, {0xFF000000, 0xFFFFFFFF, 0xFFFFFFFF}},
        {BYTES("P5 3 1 4\n\0\1\3"), 3, 1, {0xFF000000, 0xFF404040, 0xFFBFBFBF}},
        {BYTES("P5 2 1 65535\n\0\x80\0\x81"), 2, 1, {0xFF000000, 0xFF010101}},
        {BYTES("P5 2 1 256\n\1\0\0\x80"), 2, 1, {0xFFFFFFFF, 0xFF808080}},
        {BYTES("P6 1 1 7\n\0\3\7\n"), 1, 1, {0xFF006DFF}},
        {BYTES("P6 1 1 65535\n\xFF\xFF\0\0\x12\x34\r\n"), 1, 1, {0xFFFF0012}},
        {BYTES("P2 3 1 100 # c\n50 33 100\n\n"),
         3,
         1,
         {0xFF808080, 0xFF545454, 0xFFFFFFFF}},
        {BYTES("P3 1 1 1023\n1023 512 3"), 1, 1, {0xFFFF8001}},
        {BYTES("P4 9 1\n\xAA\x80"),
         9,
         1,
         {0xFF000000, 0xFFFFFFFF, 0xFF000000, 0xFFFFFFFF, 0xFF000000,
          0xFFFFFFFF, 0xFF000000, 0xFFFFFFFF, 0xFF000000}},
        {BYTES("P1\n3 2\n101\n0 1 0\n"),
         3,
         2,
         {0xFF000000, 0xFFFFFFFF, 0xFF000000, 0xFFFFFFFF, 0xFF000000,
          0xFFFFFFFF}},
        {BYTES("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\n"
               "TUPLTYPE RGB_ALPHA\nENDHDR\nabc\x80"),
         1,
         1,
         {0x80616263}},
        {BYTES("P7\n# c\nDEPTH 2\nMAXVAL 15\nHEIGHT 1\nWIDTH 2\nENDHDR\n"
               "\1\2\3\4"),
         2,
         1,
         {0x22111111, 0x44333333}},
        {BYTES("P7\nWIDTH 2\nHEIGHT 1\nDEPTH 1\nMAXVAL 1\n"
               "TUPLTYPE BLACKANDWHITE\nENDHDR\n\0\1"),
         2,
         1,
         {0xFF000000, 0xFFFFFFFF}},
        {BYTES("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 3\nMAXVAL 65535\nENDHDR\n"
               "\xFF\xFF\0\x81\0\x80"),
         1,
         1,
         {0xFFFF0100}},
    };
    for (size_t i = 0; i < sizeof(rows) / sizeof(*rows); i++) {
        char what[16];
        snprintf(what, sizeof(what), "row %zu", i);
        expect(what, rows[i].data, rows[i].size, rows[i].width, rows[i].height,
               rows[i].color);
    }
    refused("the sample is 5: 4 at most", BYTES("P5 1 1 4\n\5"));
    refused("the sample must be 0 or 1", BYTES("P1 2 1\n02"));
    refused("ends in row 1 of 1, 2 bytes a row", BYTES("P4 9 1\n\xAA"));
    refused("ends in row 1 of 1, 2 bytes a row", BYTES("P5 1 1 256\n\1"));
    refused("has 'DEPHT': expected", BYTES("P7\nDEPHT 1\nENDHDR\n"));
    refused("0 x 0 pixels", BYTES("P7\nDEPTH 1\nMAXVAL 1\nENDHDR\n"));
    refused("expected its DEPTH and MAXVAL", BYTES("P7\nWIDTH 1\nENDHDR\n"));
    refused("but there is more", BYTES("P5 1 1 4\n\1\nP5"));
}

int main(void)
{
    return run_all_tests();
}
