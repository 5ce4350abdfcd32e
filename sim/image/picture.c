/* Pictures in memory, and written to files. PPM is P6. BMP has a
 * BITMAPINFOHEADER, 24 bits, rows from the bottom, each padded to 4 bytes; its
 * numbers are little-endian. Writers return false when memory is short or a
 * library refuses; errors of the stream are the caller's to check. */
#include "sim/image/picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/cli/output.h"

#ifdef HAVE_LIBPNG
#include <png.h>
#endif

bool picture_size_legal(int width, int height)
{
    return width >= 1 && height >= 1 && width <= PICTURE_SIZE_MAX &&
           height <= PICTURE_SIZE_MAX && width <= PICTURE_PIXELS_MAX / height;
}

bool picture_size_check(const char *path, int64_t width, int64_t height)
{
    return (width <= PICTURE_SIZE_MAX && height <= PICTURE_SIZE_MAX &&
            picture_size_legal((int)width, (int)height)) ||
           message_error_at(path, 0,
                            "a picture of %lld x %lld pixels: expected 1 to %d "
                            "each way, %d in all",
                            (long long)width, (long long)height,
                            PICTURE_SIZE_MAX, PICTURE_PIXELS_MAX);
}

bool picture_init(struct picture *picture, int width, int height,
                  pel_color color)
{
    *picture = (struct picture){0, 0, NULL};
    if (!picture_size_check(NULL, width, height))
        return false;
    const size_t n = (size_t)width * (size_t)height;
    picture->pixels = malloc(n * sizeof *picture->pixels);
    if (!picture->pixels)
        return message_error("no memory for a picture of %d x %d pixels", width,
                             height);
    picture->width = width;
    picture->height = height;
    for (size_t i = 0; i < n; i++)
        picture->pixels[i] = color;
    return true;
}

void picture_free(struct picture *picture)
{
    free(picture->pixels);
    *picture = (struct picture){0, 0, NULL};
}

bool path_has_ending(const char *path, const char *endings)
{
    char word[16];
    const char *dot = strrchr(path, '.');
    if (!dot || strchr(dot, ' ') || strlen(dot) > sizeof word - 3)
        return false;
    snprintf(word, sizeof word, " %s ", dot);
    return strcasestr(endings, word) != NULL;
}

/* Writes a picture row by row; the last row that was fetched is `bytes`, red
 * first. */
struct writer {
    const struct picture_rows *rows;
    FILE *file;
    pel_color *colors;
    unsigned char *bytes;
};

static size_t fetch_row(const struct writer *w, int y)
{
    const size_t n = (size_t)w->rows->width;
    unsigned char *to = w->bytes;
    w->rows->row(w->rows->context, y, w->colors);
    for (size_t i = 0; i < n; i++) {
        *to++ = (unsigned char)pel_red(w->colors[i]);
        *to++ = (unsigned char)pel_green(w->colors[i]);
        *to++ = (unsigned char)pel_blue(w->colors[i]);
    }
    return 3 * n;
}

static bool write_ppm(const struct writer *w)
{
    fprintf(w->file, "P6\n%d %d\n255\n", w->rows->width, w->rows->height);
    for (int y = 0; y < w->rows->height && !ferror(w->file); y++)
        fwrite(w->bytes, 1, fetch_row(w, y), w->file);
    return true;
}

static void put32(unsigned char *to, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        to[i] = (unsigned char)(v >> 8 * i & 255);
}

/* A picture at the limit has 32,767 x 98,304 bytes: below 2^32. */
static bool write_bmp(const struct writer *w)
{
    enum { FILE_HEADER = 14, INFO_HEADER = 40, HEADERS = 54 };
    const struct picture_rows *p = w->rows;
    const size_t row = 3 * (size_t)p->width, padding = (size_t)p->width % 4;
    const uint32_t size = (uint32_t)((row + padding) * (size_t)p->height);
    unsigned char h[HEADERS] = {'B', 'M', [26] = 1, [28] = 24};
    put32(h + 2, HEADERS + size);
    put32(h + 10, HEADERS);
    put32(h + FILE_HEADER, INFO_HEADER);
    put32(h + 18, (uint32_t)p->width);
    put32(h + 22, (uint32_t)p->height);
    put32(h + 34, size);
    fwrite(h, 1, sizeof h, w->file);
    for (int y = p->height; y-- > 0 && !ferror(w->file);) {
        const unsigned char *end = w->bytes + fetch_row(w, y);
        for (const unsigned char *rgb = w->bytes; rgb < end; rgb += 3) {
            putc_unlocked(rgb[2], w->file);
            putc_unlocked(rgb[1], w->file);
            putc_unlocked(rgb[0], w->file);
        }
        fwrite("\0\0", 1, padding, w->file);
    }
    return true;
}

#ifdef HAVE_LIBPNG

/* libpng comes back here with false when something fails. */
static bool write_png_rows(const struct writer *w, png_struct *png,
                           png_info *info)
{
    const struct picture_rows *p = w->rows;
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_init_io(png, w->file);
    png_set_IHDR(png, info, (png_uint_32)p->width, (png_uint_32)p->height, 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, 0, 0);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    for (int y = 0; y < p->height; y++) {
        fetch_row(w, y);
        png_write_row(png, w->bytes);
    }
    png_write_end(png, info);
    return true;
}

static bool write_png(const struct writer *w)
{
    png_struct *png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_info *info = png ? png_create_info_struct(png) : NULL;
    const bool done = info && write_png_rows(w, png, info);
    png_destroy_write_struct(&png, &info);
    return done || ferror(w->file); /* of the stream it is told in the end */
}

#endif

struct picture_format {
    const char *ending;
    bool (*write)(const struct writer *writer);
};

static const struct picture_format formats[] = {
    {" .ppm ", write_ppm},
    {" .bmp ", write_bmp},
#ifdef HAVE_LIBPNG
    {" .png ", write_png},
#endif
    {NULL, NULL},
};

/* A name that is an ending alone has none. */
static const struct picture_format *format_of(const char *path)
{
    const struct picture_format *format = formats;
    if (strcmp(path, "-") == 0)
        return format;
    while (format->ending &&
           !(*path && path_has_ending(path + 1, format->ending)))
        format++;
    return format->ending ? format : NULL;
}

bool picture_path_check(const char *path)
{
    if (format_of(path))
        return true;
    if (path_has_ending(path, " .png "))
        return message_error_at(path, 0,
                                "this pel was built without libpng: install "
                                "libpng-dev and pkg-config and build again, "
                                "or write .ppm or .bmp");
    return message_error_at(path, 0,
                            "unknown picture format: expected a name that "
                            "ends in .ppm, .bmp or .png");
}

bool picture_save_rows(const struct picture_rows *rows, const char *path)
{
    struct output output;
    const size_t n = (size_t)rows->width;
    if (!picture_path_check(path) || !output_open(&output, path))
        return false;
    const struct writer writer = {rows, output.stream,
                                  malloc(n * sizeof(pel_color)), malloc(3 * n)};
    const bool done =
        writer.colors && writer.bytes && format_of(path)->write(&writer);
    free(writer.colors);
    free(writer.bytes);
    if (done)
        return output_commit(&output);
    output_abandon(&output);
    return message_error_at(path, 0, "the picture cannot be written");
}

static void copy_row(const void *picture, int y, pel_color *row)
{
    const struct picture *p = picture;
    memcpy(row, picture_row(p, y), (size_t)p->width * sizeof *row);
}

bool picture_save(const struct picture *picture, const char *path)
{
    const struct picture_rows rows = {picture->width, picture->height, copy_row,
                                      picture};
    return picture_save_rows(&rows, path);
}

const char *picture_best_ending(void)
{
#ifdef HAVE_LIBPNG
    return ".png";
#else
    return ".bmp";
#endif
}
