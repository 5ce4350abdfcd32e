/* Picture files: PPM and PGM that are right, and all the ways in which they can
 * be wrong; PPM, BMP and PNG as written. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifdef HAVE_LIBPNG
#include <png.h>
#endif

#include "sim/cli/message.h"
#include "sim/image/picture.h"
#include "files.h"

static void write_file(const char *path, const void *data, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(data, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static size_t read_file(const char *path, void *data, size_t size)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return 0;
    const size_t n = fread(data, 1, size, file);
    fclose(file);
    return n;
}

/* picture_read_ppm, and what it says. */
static bool load(struct picture *picture, const char *path, struct messages *m)
{
    messages_begin(m);
    FILE *file = fopen(path, "rb");
    const bool done =
        file ? picture_read_ppm(picture, file, path)
             : message_error_at(path, 0, "cannot be read: %s", strerror(errno));
    if (file)
        fclose(file);
    messages_end(m);
    return done;
}

struct row {
    const char *data;
    size_t size;
    const char *message; /* part of what is said; NULL when the file is right */
};

#define ROW(data, message)              \
    {                                   \
        data, sizeof(data) - 1, message \
    }

/* All the right ones are 2 x 1 pixels, 10 20 30 and 40 50 60, or as grey 10 and
 * 40. */
static const struct row rows[] = {
    ROW("P6 2 1 255\n\x0a\x14\x1e\x28\x32\x3c", NULL),
    ROW("P6\n# a comment\n2 # another\n#\n1\n255\n\x0a\x14\x1e\x28\x32\x3c",
        NULL),
    ROW("P6#comment\r\n2\t1\v255\f\x0a\x14\x1e\x28\x32\x3c", NULL),
    ROW("P6 0002 00000000001 255 \x0a\x14\x1e\x28\x32\x3c", NULL),
    ROW("P3 2 1 255\n10 20 30\n40 50 60", NULL),
    ROW("P3\n2\n1\n255\n10\n20 # c\n30 040 50\n\n60 \n# end", NULL),
    ROW("P5 2 1 255\n\x0a\x28", NULL),
    ROW("P2 2 1 255 10 40\n", NULL),
    /* The beginning. */
    ROW("", "must begin with P6, P5, P3 or P2"),
    ROW("P", "must begin with P6, P5, P3 or P2"),
    ROW("P6", "white space must follow P6"),
    ROW("P62 1 255\n", "white space must follow P6"),
    ROW("P8 2 1\n\x80", "must begin with P6, P5, P3 or P2"),
    ROW("P\0006 2 1", "must begin with P6, P5, P3 or P2"),
    ROW("P\000", "must begin with P6, P5, P3 or P2"),
    ROW("P7\nWIDTH 2", "ends before the line ENDHDR"),
    ROW("p6 2 1 255\n\x0a\x14\x1e\x28\x32\x3c", "must begin with P6"),
    ROW("\x89PNG\r\n\x1a\n", "must begin with P6"),
    /* Width, height, maximum. */
    ROW("P6 ", ":1: ends before the width"),
    ROW("P6\n#", ":2: ends before the width"),
    ROW("P6\n2\n", ":3: ends before the height"),
    ROW("P6 2 1", "ends before the maximum sample value"),
    ROW("P6\n\nx 1 255\n", ":3: byte 4: the width must be a number"),
    ROW("P6 -2 1 255\n", "byte 3: the width must be a number"),
    ROW("P6 2x1 255\n", "byte 4: white space must follow the width"),
    ROW("P6 0 1 255\n", "0 x 1 pixels: width and height must be at least 1"),
    ROW("P6 32767 8193 255\n", "a picture of 32767 x 8193 pixels: expected 1"),
    ROW("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 1\nMAXVAL 9\nENDHDR\r\n1",
        "ENDHDR ends in a carriage return: expected a line feed alone"),
    ROW("P6 1 0 255\n", "1 x 0 pixels: width and height must be at least 1"),
    ROW("P6 32768 1 255\n", "the width is too large: 32767 at most"),
    ROW("P6 1 99999999999999999999 255\n", "the height is too large: 32767"),
    ROW("P6 4294967298 1 255\n", "the width is too large: 32767 at most"),
    ROW("P6 2 1 65535\n\x0a\x14\x1e\x28\x32\x3c",
        "byte 19: ends in row 1 of 1, 12"),
    ROW("P6 2 1 15\n\x0a\x14\x1e\x28\x32\x3c", "byte 12: the sample is 20: 15"),
    ROW("P6 2 1 0\n\x0a\x14\x1e\x28\x32\x3c",
        "value is 0: expected 1 to 65535"),
    ROW("P6 2 1 65536\n", "value is too large: 65535 at most"),
    ROW("P6 2 1 255", "byte 10: ends in row 1 of 1, 6 bytes a row"),
    ROW("P6 2 1 255# c\n\x0a\x14\x1e\x28\x32\x3c", "white space must follow"),
    /* The pixels: too few, too many. */
    ROW("P6 2 1 255\n", "byte 11: ends in row 1 of 1"),
    ROW("P6 2 1 255\n\x0a\x14\x1e\x28\x32", "byte 16: ends in row 1 of 1"),
    ROW("P6 2 3 255\n\x0a\x14\x1e\x28\x32\x3c", "ends in row 2 of 3"),
    ROW("P6 32767 8192 255\n\x0a", "byte 19: ends in row 1 of 8192"),
    ROW("P5 32767 8192 255\n\x0a", "byte 19: ends in row 1 of 8192"),
    ROW("P6 2 1 255\n\x0a\x14\x1e\x28\x32\x3c\n", NULL),
    ROW("P6 2 1 255\n\x0a\x14\x1e\x28\x32\x3c\n1", "byte 18: the picture"),
    ROW("P6 2 1 255\r\n\x0a\x14\x1e\x28\x32\x3c", "byte 17: the picture of"),
    ROW("P3 2 1 255\n10 20 30\n40 50", ":3: ends before the sample"),
    ROW("P3 2 1 255\n10 20 30\n40 50 256", ":3: the sample is too large"),
    ROW("P3 2 1 255\n10 20 30\n40 50 6a", ":3: byte 27: white space"),
    ROW("P3 2 1 255\n10 20 30\n40 50 -1", ":3: byte 26: the sample must be"),
    ROW("P3 2 1 255\n10 20 30 40 50 60\n70", ":3: byte 29: the picture of"),
    ROW("P3 32767 8192 255\n1 2 3", ":2: ends before the sample"),
    ROW("P2 2 1 255\n10\0 40", ":2: byte 13: white space"),
};

static void check_pixels(size_t i, const struct picture *p, bool gray)
{
    static const pel_color color[2] = {0xFF0A141E, 0xFF28323C};
    static const pel_color level[2] = {0xFF0A0A0A, 0xFF282828};
    if (p->width != 2 || p->height != 1 ||
        memcmp(p->pixels, gray ? level : color, sizeof color) != 0)
        fail_msg("row %zu: %d x %d, %08x", i, p->width, p->height,
                 (unsigned)p->pixels[0]);
}

TEST(read)
{
    char path[64];
    path_of("in.ppm", path, sizeof path);
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct messages m;
        struct picture p;
        write_file(path, rows[i].data, rows[i].size);
        const bool done = load(&p, path, &m);
        if (done != !rows[i].message)
            fail_msg("row %zu: %s", i, done ? "was read" : m.text);
        if (done)
            check_pixels(i, &p,
                         rows[i].data[1] == '5' || rows[i].data[1] == '2');
        else if (!strstr(m.text, rows[i].message) ||
                 strncmp(m.text, "pel: /", 6) != 0 || p.pixels)
            fail_msg("row %zu: said %s, not %s", i, m.text, rows[i].message);
        picture_free(&p);
    }
}

/* Every way to cut a file short is found, in the header and in the pixels. */
TEST(truncated)
{
    static const char *const whole[] = {"P6 3 2 255\nABCDEFGHIJKLMNOPQR",
                                        "P5\n3 2 # c\n255\nABCDEF",
                                        "P3 1 2 255\n1 2 3 4 5 66"};
    char path[64];
    struct messages m;
    path_of("cut.ppm", path, sizeof path);
    for (size_t i = 0; i < sizeof whole / sizeof whole[0]; i++) {
        const size_t size = strlen(whole[i]);
        for (size_t n = 0; n <= size; n++) {
            struct picture p;
            /* One digit less of the last sample is a picture too. */
            const bool right = n == size || (i == 2 && n == size - 1);
            write_file(path, whole[i], n);
            if (load(&p, path, &m) != right)
                fail_msg("%zu bytes of file %zu", n, i);
            picture_free(&p);
        }
    }
}

TEST(missing)
{
    char path[64];
    struct messages m;
    struct picture p;
    path_of("none.ppm", path, sizeof path);
    assert_false(load(&p, path, &m));
    assert_non_null(strstr(m.text, "none.ppm: cannot be read: No such file"));
    assert_false(load(&p, directory, &m));
    assert_null(p.pixels);
}

static void fill_picture(struct picture *p, int width, int height)
{
    uint32_t seed = (uint32_t)(width * 131 + height);
    assert_true(picture_init(p, width, height, 0));
    for (int i = 0; i < width * height; i++) {
        seed = seed * 1664525u + 1013904223u;
        p->pixels[i] = 0xFF000000u | seed >> 8;
    }
}

/* Is the file at `path` the picture? */
typedef void check_file(const struct picture *p, const char *path);

static void check_saved(const char *name, check_file *check)
{
    static const int sizes[][2] = {{1, 1}, {2, 3}, {3, 2}, {4, 5}, {257, 63}};
    char path[64];
    path_of(name, path, sizeof path);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct picture p;
        fill_picture(&p, sizes[i][0], sizes[i][1]);
        assert_true(picture_save(&p, path));
        check(&p, path);
        picture_free(&p);
    }
}

static void check_ppm(const struct picture *p, const char *path)
{
    const size_t size = (size_t)p->width * (size_t)p->height * 4;
    struct picture read;
    struct messages m;
    assert_true(load(&read, path, &m));
    assert_true(read.width == p->width && read.height == p->height);
    assert_memory_equal(p->pixels, read.pixels, size);
    picture_free(&read);
}

TEST(ppm)
{
    check_saved("out.ppm", check_ppm);
}

static uint32_t get32(const unsigned char *p)
{
    return (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 |
           (uint32_t)p[3] << 24;
}

static void check_bmp(const struct picture *p, const char *path)
{
    static unsigned char data[1 << 17];
    const size_t size = read_file(path, data, sizeof data);
    const size_t line = ((size_t)p->width * 3 + 3) / 4 * 4;
    assert_memory_equal(data, "BM", 2);
    assert_int_equal(get32(data + 2), size);
    assert_int_equal(size, get32(data + 10) + line * (size_t)p->height);
    assert_int_equal(get32(data + 14), 40);
    assert_int_equal(get32(data + 18), p->width);
    assert_int_equal(get32(data + 22), p->height);
    assert_int_equal(get32(data + 26), 24 << 16 | 1);
    for (int y = 0; y < p->height; y++) {
        const unsigned char *row =
            data + get32(data + 10) + line * (size_t)(p->height - 1 - y);
        for (int x = 0; x < p->width; x++, row += 3)
            assert_int_equal(PEL_RGB(row[2], row[1], row[0]),
                             picture_row(p, y)[x]);
    }
}

TEST(bmp)
{
    check_saved("out.BMP", check_bmp);
}

#ifdef HAVE_LIBPNG
static void check_png(const struct picture *p, const char *path)
{
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_int_not_equal(png_image_begin_read_from_file(&image, path), 0);
    assert_int_equal(image.width, p->width);
    assert_int_equal(image.height, p->height);
    image.format = PNG_FORMAT_RGB;
    unsigned char *data = malloc(PNG_IMAGE_SIZE(image));
    assert_non_null(data);
    assert_int_not_equal(png_image_finish_read(&image, NULL, data, 0, NULL), 0);
    for (int i = 0; i < p->width * p->height; i++)
        assert_int_equal(PEL_RGB(data[3 * i], data[3 * i + 1], data[3 * i + 2]),
                         p->pixels[i]);
    free(data);
}

TEST(png)
{
    assert_string_equal(picture_best_ending(), ".png");
    check_saved("out.png", check_png);
}
#else
/* Without libpng, PNG is refused with the name of the package. */
TEST(png)
{
    struct messages m;
    assert_string_equal(picture_best_ending(), ".bmp");
    messages_begin(&m);
    const bool right = picture_path_check("a.png");
    messages_end(&m);
    assert_false(right);
    assert_non_null(strstr(m.text, "libpng-dev"));
}
#endif

TEST(endings)
{
    struct messages m;
    messages_begin(&m);
    const bool wrong = picture_path_check("a.jpg") || picture_path_check("a") ||
                       picture_path_check(".ppm") ||
                       picture_path_check("a.ppm/b");
    messages_end(&m);
    assert_false(wrong);
    assert_true(picture_path_check("a.ppm"));
    assert_true(picture_path_check("b.c/a.bmp"));
    assert_true(picture_path_check("-"));
}

/* A directory that is not there: a message, and no file anywhere. */
TEST(no_directory)
{
    char path[64];
    struct messages m;
    struct picture p;
    path_of("none/out.ppm", path, sizeof path);
    fill_picture(&p, 2, 2);
    messages_begin(&m);
    const bool done = picture_save(&p, path);
    messages_end(&m);
    picture_free(&p);
    assert_false(done);
    assert_non_null(strstr(m.text, "none/out.ppm: cannot be written: No such"));
}

int main(void)
{
    static const char *const names[] = {"in.ppm",  "cut.ppm", "out.ppm",
                                        "out.BMP", "out.png", NULL};
    if (!mkdtemp(directory))
        return 1;
    const int failed = run_all_tests();
    return remove_folder(names) || failed;
}
