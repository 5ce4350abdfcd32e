#include "sim/image/decode.h"

#include "sim/cli/message.h"

#ifdef HAVE_LIBJPEG
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

#include <jpeglib.h>
#include <jerror.h>

#include "sim/cli/bytes.h"

enum { EXIF_MARKER = JPEG_APP0 + 1, ORIENTATION = 0x0112, SHORT = 3 };

struct errors {
    struct jpeg_error_mgr base;
    jmp_buf jump;
    const struct encoded *from;
};

__attribute__((noreturn)) static void fail(j_common_ptr jpeg)
{
    struct errors *e = (void *)jpeg->err;
    char text[JMSG_LENGTH_MAX];
    jpeg->err->format_message(jpeg, text);
    message_error_at(e->from->name, 0, "no JPEG that can be read (%s)", text);
    longjmp(e->jump, 1);
}

/* libjpeg goes on after these with grey or black. */
static void warn(j_common_ptr jpeg, int level)
{
    struct errors *e = (void *)jpeg->err;
    const int code = jpeg->err->msg_code;
    if (level >= 0)
        return;
    if (code == JWRN_JPEG_EOF) {
        decode_refuse_end(e->from);
        longjmp(e->jump, 1);
    }
    if (code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE ||
        code == JWRN_MUST_RESYNC || code == JWRN_ARITH_BAD_CODE)
        fail(jpeg);
}

/* 1 to 8; 1 where the file does not say. */
static unsigned orientation_of(const struct jpeg_decompress_struct *jpeg)
{
    jpeg_saved_marker_ptr m = jpeg->marker_list;
    while (m && !(m->marker == EXIF_MARKER && m->data_length >= 14 &&
                  memcmp(m->data, "Exif\0", 6) == 0))
        m = m->next;
    if (!m)
        return 1;
    const uint8_t *tiff = m->data + 6;
    const size_t size = m->data_length - 6;
    uint32_t (*number)(const uint8_t *, int) =
        *tiff == 'M' ? bytes_big : bytes_little;
    const size_t at = number(tiff + 4, 4);
    const size_t entries = at <= size - 2 ? number(tiff + at, 2) : 0;
    for (size_t i = 0; i < entries && at + 14 + 12 * i <= size; i++) {
        const uint8_t *entry = tiff + at + 2 + 12 * i;
        if (number(entry, 2) == ORIENTATION && number(entry + 2, 2) == SHORT)
            return number(entry + 8, 2);
    }
    return 1;
}

/* Orientations from 5 on exchange rows and columns; 2 is mirrored, 3 turned
 * by half, 4 upside down. */
static bool turn(struct picture *picture, unsigned orientation)
{
    static const bool mirrored[9] = {[2] = 1, [3] = 1, [7] = 1, [8] = 1};
    static const bool from_below[9] = {[3] = 1, [4] = 1, [6] = 1, [7] = 1};
    const int w = picture->width, h = picture->height;
    struct picture to;
    if (orientation < 2 || orientation > 8)
        return true;
    const bool exchanged = orientation >= 5;
    if (!picture_init(&to, exchanged ? h : w, exchanged ? w : h, 0))
        return false;
    for (int y = 0; y < to.height; y++)
        for (int x = 0; x < to.width; x++) {
            int column = exchanged ? y : x, row = exchanged ? x : y;
            if (mirrored[orientation])
                column = w - 1 - column;
            if (from_below[orientation])
                row = h - 1 - row;
            picture_row(&to, y)[x] = picture_row(picture, row)[column];
        }
    picture_free(picture);
    *picture = to;
    return true;
}

/* Adobe's programs write ink upside down, and a marker that says so. */
static pel_color color_of(const struct jpeg_decompress_struct *jpeg,
                          const uint8_t *c)
{
    const unsigned flip = jpeg->saw_Adobe_marker ? 0 : 255;
    uint32_t v[3];
    if (jpeg->out_color_space != JCS_CMYK)
        return PEL_RGB(c[0], c[1], c[2]);
    for (int k = 0; k < 3; k++)
        v[k] = pel_round_div255((c[k] ^ flip) * (c[3] ^ flip));
    return PEL_RGB(v[0], v[1], v[2]);
}

static bool read_rows(struct jpeg_decompress_struct *jpeg,
                      struct picture *picture)
{
    uint8_t *row = malloc(4 * (size_t)picture->width);
    if (!row)
        return message_error("no memory for a row of %d pixels",
                             picture->width);
    while (jpeg->output_scanline < jpeg->output_height) {
        pel_color *to = picture_row(picture, (int)jpeg->output_scanline);
        jpeg_read_scanlines(jpeg, &row, 1);
        for (int x = 0; x < picture->width; x++)
            to[x] = color_of(jpeg, row + jpeg->output_components * x);
    }
    free(row);
    return true;
}

bool decode_jpeg(struct picture *picture, const struct encoded *from)
{
    struct jpeg_decompress_struct jpeg;
    struct errors errors = {.from = from};
    jpeg.err = jpeg_std_error(&errors.base);
    errors.base.error_exit = fail;
    errors.base.emit_message = warn;
    if (setjmp(errors.jump))
        return false;
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, from->bytes, (unsigned long)from->size);
    jpeg_save_markers(&jpeg, EXIF_MARKER, 0xFFFF);
    jpeg_read_header(&jpeg, TRUE);
    if (!picture_size_check(from->name, jpeg.image_width, jpeg.image_height) ||
        !picture_init(picture, (int)jpeg.image_width, (int)jpeg.image_height,
                      0))
        return false;
    jpeg.out_color_space = jpeg.num_components == 4 ? JCS_CMYK : JCS_RGB;
    jpeg_start_decompress(&jpeg);
    if (!read_rows(&jpeg, picture))
        return false;
    const unsigned orientation = orientation_of(&jpeg);
    jpeg_finish_decompress(&jpeg); /* frees the markers */
    return turn(picture, orientation);
}

#else

bool decode_jpeg(struct picture *picture, const struct encoded *from)
{
    (void)picture;
    return message_error_at(from->name, 0,
                            "this pel was built without libjpeg, which reads "
                            "JPEG: the package libjpeg-dev brings it");
}

#endif
