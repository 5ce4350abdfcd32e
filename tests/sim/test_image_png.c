/* PNG of every kind, written by libpng, and the pixels that they are by the
 * rules that PngSuite holds readers to. */
#include "encoded.h"

#ifdef HAVE_LIBPNG
#include <png.h>

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
        expect(&(struct expected){what, SIDE, SIDE, color}, b.at, b.n);
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
#else
int main(void)
{
    return 0;
}
#endif
