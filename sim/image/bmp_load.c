/* BMP: a file header of 14 bytes, a header whose size tells its kind, masks, a
 * palette, and rows, from the bottom unless the height is negative, each padded
 * to 4 bytes. */
#include "sim/image/decode.h"

#include <string.h>

#include "core/format/word.h"
#include "sim/cli/bytes.h"
#include "sim/cli/message.h"

enum compression { RGB, RLE8, RLE4, MASKS, JPEG, PNG, ALPHA_MASKS };

struct bmp {
    const struct encoded *from;
    int64_t width, height;
    bool from_top;
    int bits;
    uint32_t compression;
    uint32_t mask[4]; /* red, green, blue, alpha */
    pel_color palette[256];
    uint32_t colors;
    const uint8_t *rows, *end;
};

static uint32_t number(const struct bmp *b, size_t at, int n)
{
    return bytes_little(b->from->bytes + at, n);
}

static bool refuse(const struct bmp *b, const char *what, uint32_t value)
{
    return message_error_at(b->from->name, 0,
                            "a BMP whose %s is %u: expected one that Windows "
                            "writes, without a JPEG or PNG inside",
                            what, value);
}

/* Those of OS/2 1 have 12 bytes and sizes of 16 bits. */
static bool read_header(struct bmp *b, uint32_t header)
{
    const bool old = header == 12;
    const int n = old ? 2 : 4;
    if (!old && header != 16 && (header < 40 || header > 124))
        return refuse(b, "header", header);
    if (b->from->size < 14 + (size_t)header)
        return decode_refuse_end(b->from);
    const uint32_t height = number(b, 18 + (size_t)n, n);
    b->from_top = height >> 31;
    b->width = number(b, 18, n);
    b->height = b->from_top ? (int64_t)(0 - height) : (int64_t)height;
    b->bits = (int)number(b, old ? 24 : 28, 2);
    b->compression = header >= 40 ? number(b, 30, 4) : RGB;
    return picture_size_check(b->from->name, b->width, b->height);
}

/* Windows has a mode for each number of bits; OS/2 2 gave 3 and 4 another
 * meaning, with 1 and 24 bits. */
static bool check_mode(const struct bmp *b)
{
    const uint32_t c = b->compression;
    const int bits = b->bits;
    const bool known = bits == 1 || bits == 2 || bits == 4 || bits == 8 ||
                       bits == 16 || bits == 24 || bits == 32;
    const bool fits = c == RGB    ? true
                      : c == RLE8 ? bits == 8
                      : c == RLE4 ? bits == 4
                                  : (c == MASKS || c == ALPHA_MASKS) &&
                                        (bits == 16 || bits == 32);
    if (!known)
        return refuse(b, "number of bits", (uint32_t)bits);
    if (b->from_top && (c == RLE8 || c == RLE4))
        return refuse(b, "row order is from the top and whose compression", c);
    return fits || refuse(b, "compression", c);
}

/* Are the bits of a mask beside each other, and no other's? */
static bool check_masks(const struct bmp *b)
{
    uint32_t all = 0;
    for (int k = 0; k < 4; k++) {
        const uint32_t mask = b->mask[k], low = mask & (0 - mask);
        if ((mask & all) || (mask & (mask + low)) ||
            (b->bits == 16 && mask >> 16) || (k < 3 && !mask))
            return refuse(b, "mask", mask);
        all |= mask;
    }
    return true;
}

/* Of a header of 40 bytes they stand behind it. */
static bool read_masks(struct bmp *b, uint32_t header, size_t *at)
{
    static const uint32_t plain[2][3] = {{0x7C00, 0x3E0, 0x1F},
                                         {0xFF0000, 0xFF00, 0xFF}};
    const bool stated =
        b->compression == MASKS || b->compression == ALPHA_MASKS;
    const int n = header >= 56 || b->compression == ALPHA_MASKS ? 4 : 3;
    if (b->bits != 16 && b->bits != 32)
        return true;
    if (stated && header < 52)
        *at += 4 * (size_t)n;
    if (stated && b->from->size < 54 + 4 * (size_t)n)
        return decode_refuse_end(b->from);
    for (int k = 0; k < 4; k++)
        b->mask[k] = stated ? (k < n ? number(b, 54 + 4 * (size_t)k, 4) : 0)
                            : (k < 3 ? plain[b->bits / 32][k] : 0);
    return check_masks(b);
}

/* More colors than there are indices, or fit before the rows, are left out. */
static bool read_palette(struct bmp *b, uint32_t header, size_t at)
{
    const size_t bytes = header == 12 ? 3 : 4;
    const uint32_t rows = number(b, 10, 4);
    const uint32_t most = b->bits <= 8 ? 1u << b->bits : 0;
    const uint32_t used = header >= 40 ? number(b, 46, 4) : 0;
    if (rows < at)
        return message_error_at(b->from->name, 0,
                                "a BMP whose rows begin at byte %u: expected "
                                "%zu or more, behind its headers",
                                rows, at);
    b->colors = used > 0 && used < most ? used : most;
    if (b->colors > (rows - at) / bytes)
        b->colors = (uint32_t)((rows - at) / bytes);
    if (at + bytes * b->colors > b->from->size)
        return decode_refuse_end(b->from);
    for (uint32_t i = 0; i < b->colors; i++, at += bytes)
        b->palette[i] = number(b, at, 3) | PEL_RGB(0, 0, 0);
    return true;
}

/* A channel of `n` bits, as 8: repeated, or of more rounded. */
static uint32_t to_byte(uint32_t value, int n)
{
    const uint64_t most = (UINT64_C(1) << n) - 1;
    return n > 8 ? (uint32_t)((value * UINT64_C(510) + most) / (2 * most))
                 : pel_widen(value, n);
}

static pel_color color_of(const struct bmp *b, uint32_t pixel)
{
    uint32_t v[4] = {0, 0, 0, 255};
    for (int k = 0; k < 4; k++) {
        uint32_t mask = b->mask[k];
        int low = 0, n = 0;
        while (mask && !(mask >> low & 1))
            low++;
        while (low + n < 32 && mask >> low >> n & 1)
            n++;
        if (mask)
            v[k] = to_byte((pixel & mask) >> low, n);
    }
    return PEL_RGBA(v[0], v[1], v[2], v[3]);
}

static bool set_index(const struct bmp *b, pel_color *to, uint32_t i)
{
    if (i >= b->colors)
        return message_error_at(b->from->name, 0,
                                "a pixel has colour %u of %u: expected less", i,
                                b->colors);
    *to = b->palette[i];
    return true;
}

static bool read_row(const struct bmp *b, const uint8_t *from, pel_color *to)
{
    for (int x = 0; x < b->width; x++)
        if (b->bits == 24)
            to[x] = bytes_little(from + 3 * x, 3) | PEL_RGB(0, 0, 0);
        else if (b->bits > 8)
            to[x] =
                color_of(b, bytes_little(from + b->bits / 8 * x, b->bits / 8));
        else if (!set_index(b, &to[x],
                            (uint32_t)from[x * b->bits / 8] >>
                                    (8 - b->bits - x * b->bits % 8) &
                                ((UINT32_C(1) << b->bits) - 1)))
            return false;
    return true;
}

static bool read_rows(const struct bmp *b, const struct picture *picture)
{
    const size_t line = ((size_t)b->width * (size_t)b->bits + 31) / 32 * 4;
    const size_t used = ((size_t)b->width * (size_t)b->bits + 7) / 8;
    const size_t before = line * (size_t)(b->height - 1);
    if ((size_t)(b->end - b->rows) < before + used)
        return decode_refuse_end(b->from);
    for (int y = 0; y < b->height; y++)
        if (!read_row(b, b->rows + line * (size_t)y,
                      picture_row(picture,
                                  b->from_top ? y : picture->height - 1 - y)))
            return false;
    return true;
}

/* Where an RLE writes; y is counted from the bottom. */
struct pen {
    const struct bmp *b;
    const struct picture *picture;
    int64_t x, y;
};

static bool put_run(struct pen *p, const uint8_t *from, int n, bool is_run)
{
    const int bits = p->b->bits;
    if (p->x + n > p->b->width || p->y >= p->b->height)
        return message_error_at(p->b->from->name, 0,
                                "a run of %d pixels at %d, %d leaves the "
                                "picture",
                                n, (int)p->x, (int)p->y);
    pel_color *to = picture_row(p->picture, (int)(p->b->height - 1 - p->y));
    for (int i = 0; i < n; i++) {
        const uint8_t byte = from[is_run ? 0 : i * bits / 8];
        const int half = i % 2 ? byte & 15 : byte >> 4;
        if (!set_index(p->b, &to[p->x++], bits == 4 ? (unsigned)half : byte))
            return false;
    }
    return true;
}

/* Pairs: a count and its index; or 0 and 0, the row's end; 1, the picture's; 2,
 * a step right and up; n, n indices, padded to 2 bytes. */
static bool read_runs(const struct bmp *b, const struct picture *picture)
{
    struct pen pen = {b, picture, 0, 0};
    const uint8_t *p = b->rows;
    for (; b->end - p >= 2; p += 2) {
        if (p[0] > 0) {
            if (!put_run(&pen, p + 1, p[0], true))
                return false;
        } else if (p[1] == 0) {
            pen.x = 0;
            pen.y++;
        } else if (p[1] == 1) {
            return true;
        } else if (p[1] == 2) {
            if (b->end - p < 4)
                return decode_refuse_end(b->from);
            pen.x += p[2];
            pen.y += p[3];
            p += 2;
        } else {
            const int bytes = (p[1] * b->bits + 15) / 16 * 2;
            if (b->end - p - 2 < bytes)
                return decode_refuse_end(b->from);
            if (!put_run(&pen, p + 2, p[1], false))
                return false;
            p += bytes;
        }
    }
    return pen.y * b->width + pen.x >= b->height * b->width ||
           decode_refuse_end(b->from);
}

static bool read_front(struct bmp *b, const struct encoded *from)
{
    *b = (struct bmp){.from = from, .end = from->bytes + from->size};
    if (from->size < 26)
        return decode_refuse_end(from);
    const uint32_t header = bytes_little(from->bytes + 14, 4);
    size_t at = 14 + (size_t)header;
    return read_header(b, header) && check_mode(b) &&
           read_masks(b, header, &at) && read_palette(b, header, at);
}

bool decode_bmp(struct picture *picture, const struct encoded *from)
{
    struct bmp b;
    if (!read_front(&b, from))
        return false;
    const uint32_t rows = bytes_little(from->bytes + 10, 4);
    if (rows > from->size)
        return decode_refuse_end(from);
    b.rows = from->bytes + rows;
    return picture_init(picture, (int)b.width, (int)b.height, 0) &&
           (b.compression == RLE8 || b.compression == RLE4
                ? read_runs(&b, picture)
                : read_rows(&b, picture));
}

int decode_bmp_palette(const struct encoded *from, pel_color palette[256])
{
    struct bmp b;
    if (!read_front(&b, from))
        return -1;
    memcpy(palette, b.palette, sizeof(b.palette));
    return (int)b.colors;
}
