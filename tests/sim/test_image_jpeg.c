/* JPEG of RGB and of ink, with EXIF, written by libjpeg. */
#include "encoded.h"

#ifdef HAVE_LIBJPEG
#include <jpeglib.h>

/* Blocks of 16 x 16 pixels of one colour: 2 wide, 3 high. */
static const unsigned char blocks[6][3] = {{255, 0, 0},     {0, 255, 0},
                                           {0, 0, 255},     {255, 255, 0},
                                           {255, 255, 255}, {0, 0, 0}};

struct kind {
    J_COLOR_SPACE in, out;
    bool adobe;
    const char *order; /* of EXIF, "MM" or "II"; NULL: none */
    int orientation;
};

static void write_exif(struct jpeg_compress_struct *jpeg,
                       const struct kind *kind)
{
    char little[] = "Exif\0\0II\52\0\10\0\0\0\1\0\22\1\3\0\1\0\0\0"
                    "\0\0\0\0\0\0\0";
    char big[] = "Exif\0\0MM\0\52\0\0\0\10\0\1\1\22\0\3\0\0\0\1"
                 "\0\0\0\0\0\0\0";
    little[24] = big[25] = (char)kind->orientation;
    jpeg_write_marker(jpeg, JPEG_APP0 + 1,
                      (const JOCTET *)(kind->order[0] == 'M' ? big : little),
                      sizeof(big));
}

static void write_blocks(struct jpeg_compress_struct *jpeg, bool adobe)
{
    unsigned char row[32 * 4], *rows = row;
    const int n = jpeg->input_components;
    while (jpeg->next_scanline < jpeg->image_height) {
        for (int x = 0; x < 32; x++)
            for (int k = 0; k < n; k++) {
                const unsigned y = jpeg->next_scanline / 16;
                const unsigned char *c = blocks[y * 2 + (unsigned)x / 16];
                const unsigned char v = k < 3 ? c[k] : 255;
                row[x * n + k] =
                    (unsigned char)(n == 4 && !adobe ? 255 - v : v);
            }
        jpeg_write_scanlines(jpeg, &rows, 1);
    }
}

static unsigned char *make_jpeg(const struct kind *kind, unsigned long *size)
{
    struct jpeg_compress_struct jpeg;
    struct jpeg_error_mgr error;
    unsigned char *bytes = NULL;
    jpeg.err = jpeg_std_error(&error);
    jpeg_create_compress(&jpeg);
    jpeg_mem_dest(&jpeg, &bytes, size);
    jpeg.image_width = 32;
    jpeg.image_height = 48;
    jpeg.input_components = kind->in == JCS_CMYK ? 4 : 3;
    jpeg.in_color_space = kind->in;
    jpeg_set_defaults(&jpeg);
    jpeg_set_colorspace(&jpeg, kind->out);
    jpeg_set_quality(&jpeg, 100, TRUE);
    jpeg.write_Adobe_marker = kind->adobe;
    jpeg_start_compress(&jpeg, TRUE);
    if (kind->order)
        write_exif(&jpeg, kind);
    write_blocks(&jpeg, kind->adobe);
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    return bytes;
}

struct seen {
    const char *what;
    const char *blocks; /* six letters, in the order in which they are seen */
    int across;
};

static void expect_blocks(const struct seen *s, const unsigned char *bytes,
                          unsigned long size)
{
    struct messages m;
    struct picture p;
    if (!load_bytes(&p, bytes, size, &m))
        fail_msg("%s: %s", s->what, m.text);
    assert_int_equal(p.width, s->across * 16);
    assert_int_equal(p.height, 96 / s->across);
    for (int i = 0; i < 6; i++) {
        const unsigned char *c = blocks[s->blocks[i] - 'a'];
        const pel_color got =
            picture_row(&p, i / s->across * 16 + 8)[i % s->across * 16 + 8];
        if (abs((int)pel_red(got) - c[0]) > 2 ||
            abs((int)pel_green(got) - c[1]) > 2 ||
            abs((int)pel_blue(got) - c[2]) > 2 || pel_alpha(got) != 255)
            fail_msg("%s: block %d is %08x", s->what, i, (unsigned)got);
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
        const struct kind kind = {JCS_RGB, JCS_YCbCr, false,
                                  i % 2 ? "MM" : "II", orientation};
        unsigned long size;
        char what[40];
        unsigned char *bytes = make_jpeg(&kind, &size);
        snprintf(what, sizeof(what), "orientation %d, %d", orientation, i % 2);
        const int across = orientation >= 5 && orientation <= 8 ? 3 : 2;
        expect_blocks(&(struct seen){what, seen[orientation], across}, bytes,
                      size);
        free(bytes);
    }
}

/* Ink as Adobe's programs write it, upside down, and as nobody else. */
TEST(jpeg_ink)
{
    static const struct {
        const char *what;
        struct kind kind;
    } kinds[] = {{"CMYK of Adobe", {JCS_CMYK, JCS_CMYK, true, NULL, 0}},
                 {"YCCK of Adobe", {JCS_CMYK, JCS_YCCK, true, NULL, 0}},
                 {"CMYK", {JCS_CMYK, JCS_CMYK, false, NULL, 0}},
                 {"RGB", {JCS_RGB, JCS_RGB, true, NULL, 0}}};
    for (int i = 0; i < 4; i++) {
        unsigned long size;
        unsigned char *bytes = make_jpeg(&kinds[i].kind, &size);
        expect_blocks(&(struct seen){kinds[i].what, "abcdef", 2}, bytes, size);
        for (unsigned long n = 4; n < size - 2; n += 31)
            refused("in: ", bytes, n);
        free(bytes);
    }
}

#else
int main(void)
{
    return 0;
}
#endif
