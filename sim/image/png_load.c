#include "sim/image/decode.h"

#include "sim/cli/bytes.h"
#include "sim/cli/message.h"

#ifdef HAVE_LIBPNG
#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

struct reader {
    const struct encoded *from;
    size_t at;
    bool ended;
};

static void read_bytes(png_structp png, png_bytep to, size_t n)
{
    struct reader *r = png_get_io_ptr(png);
    if (n > r->from->size - r->at) {
        r->ended = true;
        png_error(png, "");
    }
    memcpy(to, r->from->bytes + r->at, n);
    r->at += n;
}

static void fail(png_structp png, png_const_charp text)
{
    const struct reader *r = png_get_error_ptr(png);
    if (r->ended)
        decode_refuse_end(r->from);
    else
        message_error_at(r->from->name, 0, "no PNG that can be read (%s)",
                         text);
    longjmp(png_jmpbuf(png), 1);
}

static void ignore(png_structp png, png_const_charp text)
{
    (void)png;
    (void)text;
}

/* Everything becomes 8 bits of red, green, blue and alpha. */
static void set_transforms(png_structp png, png_infop info)
{
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
}

static void make_pixels(struct picture *picture, const uint8_t *byte)
{
    const size_t n = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < n; i++, byte += 4)
        picture->pixels[i] = PEL_RGBA(byte[0], byte[1], byte[2], byte[3]);
}

static bool read_pixels(png_structp png, png_infop info,
                        struct picture *picture)
{
    const size_t width = (size_t)picture->width * 4;
    uint8_t *bytes = malloc(width * (size_t)picture->height);
    png_bytepp rows = malloc((size_t)picture->height * sizeof(*rows));
    if (!bytes || !rows)
        return message_error("no memory for a picture of %d x %d pixels",
                             picture->width, picture->height);
    for (int y = 0; y < picture->height; y++)
        rows[y] = bytes + width * (size_t)y;
    png_read_image(png, rows);
    png_read_end(png, info);
    make_pixels(picture, bytes);
    free(rows);
    free(bytes);
    return true;
}

/* The size stands first, where a file is not worth to be read: true also of one
 * that ends there. */
static bool check_size(const struct encoded *from)
{
    return from->size < 24 ||
           picture_size_check(from->name, bytes_big(from->bytes + 16, 4),
                              bytes_big(from->bytes + 20, 4));
}

/* A damaged chunk of transparency would be left out without a word: all must
 * be right. NULL, with a message; errors go on to where setjmp was. */
static png_structp open_png(struct reader *r, png_infop *info)
{
    png_structp png =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, r, fail, ignore);
    *info = png ? png_create_info_struct(png) : NULL;
    if (!*info) {
        message_error_at(r->from->name, 0, "no memory for libpng");
        return NULL;
    }
    png_set_read_fn(png, r, read_bytes);
    png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    return check_size(r->from) ? png : NULL;
}

bool decode_png(struct picture *picture, const struct encoded *from)
{
    struct reader reader = {from, 0, false};
    png_infop info;
    png_structp png = open_png(&reader, &info);
    if (!png || setjmp(png_jmpbuf(png)))
        return false;
    png_read_info(png, info);
    set_transforms(png, info);
    return picture_init(picture, (int)png_get_image_width(png, info),
                        (int)png_get_image_height(png, info), 0) &&
           read_pixels(png, info, picture);
}

int decode_png_palette(const struct encoded *from, pel_color palette[256])
{
    struct reader reader = {from, 0, false};
    png_infop info;
    png_structp png = open_png(&reader, &info);
    png_colorp color = NULL;
    png_bytep alpha = NULL;
    int n = 0, alphas = 0;
    if (!png || setjmp(png_jmpbuf(png)))
        return -1;
    png_read_info(png, info);
    if (png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE)
        png_get_PLTE(png, info, &color, &n);
    png_get_tRNS(png, info, &alpha, &alphas, NULL);
    for (int i = 0; i < n; i++)
        palette[i] = PEL_RGBA(color[i].red, color[i].green, color[i].blue,
                              i < alphas ? alpha[i] : 255);
    return n;
}

#else

bool decode_png(struct picture *picture, const struct encoded *from)
{
    (void)picture;
    return message_error_at(from->name, 0,
                            "this pel was built without libpng, which reads "
                            "PNG: the package libpng-dev brings it");
}

int decode_png_palette(const struct encoded *from, pel_color palette[256])
{
    struct picture none;
    (void)palette;
    return decode_png(&none, from) ? 0 : -1;
}

#endif
