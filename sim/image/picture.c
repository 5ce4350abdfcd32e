/* Pictures in memory, and written to files. PPM is P6. BMP has a
 * BITMAPINFOHEADER, 24 bits, rows from the bottom, each padded to 4 bytes; its
 * numbers are little-endian. Writers return false when memory is short or a
 * library refuses; errors of the stream, which holds the file in memory, are
 * the caller's to check. */
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

/* The first three channels of row y as bytes, red first. */
static void picture_bytes(const struct picture *picture, int y,
                          unsigned char *to)
{
    const pel_color *row = picture_row(picture, y);
    for (int x = 0; x < picture->width; x++) {
        *to++ = (unsigned char)pel_red(row[x]);
        *to++ = (unsigned char)pel_green(row[x]);
        *to++ = (unsigned char)pel_blue(row[x]);
    }
}

static bool write_ppm(const struct picture *picture, FILE *file)
{
    const size_t width = (size_t)picture->width;
    unsigned char *bytes = malloc(3 * width);
    if (!bytes)
        return false;
    fprintf(file, "P6\n%d %d\n255\n", picture->width, picture->height);
    for (int y = 0; y < picture->height; y++) {
        picture_bytes(picture, y, bytes);
        fwrite(bytes, 3, width, file);
    }
    free(bytes);
    return true;
}

enum {
    FILE_HEADER = 14,
    INFO_HEADER = 40,
    HEADERS = FILE_HEADER + INFO_HEADER
};

static void put32(unsigned char *to, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        to[i] = (unsigned char)(v >> 8 * i & 255);
}

/* A picture at the limit has 32,767 x 98,304 bytes: below 2^32. */
static void write_headers(const struct picture *p, uint32_t bytes, FILE *file)
{
    unsigned char h[HEADERS] = {'B', 'M'};
    put32(h + 2, HEADERS + bytes * (uint32_t)p->height);
    put32(h + 10, HEADERS);
    put32(h + 14, INFO_HEADER);
    put32(h + 18, (uint32_t)p->width);
    put32(h + 22, (uint32_t)p->height);
    h[26] = 1;
    h[28] = 24;
    put32(h + 34, bytes * (uint32_t)p->height);
    fwrite(h, 1, sizeof h, file);
}

static bool write_bmp(const struct picture *picture, FILE *file)
{
    const uint32_t width = (uint32_t)picture->width;
    const uint32_t size = (3 * width + 3) / 4 * 4;
    unsigned char *bytes = calloc(size, 1);
    if (!bytes)
        return false;
    write_headers(picture, size, file);
    for (int y = picture->height - 1; y >= 0; y--) {
        const pel_color *row = picture_row(picture, y);
        for (uint32_t x = 0; x < width; x++)
            for (uint32_t k = 0; k < 3; k++)
                bytes[3 * x + k] = (unsigned char)(row[x] >> 8 * k & 255);
        fwrite(bytes, 1, size, file);
    }
    free(bytes);
    return true;
}

#ifdef HAVE_LIBPNG

static void write_rows(const struct picture *picture, png_structp png,
                       png_bytep bytes)
{
    for (int y = 0; y < picture->height; y++) {
        picture_bytes(picture, y, bytes);
        png_write_row(png, bytes);
    }
}

/* libpng reports errors by jumping back to the setjmp. Nothing that changes
 * after it is read then. */
static bool write_all(const struct picture *picture, FILE *file,
                      png_structp png, png_infop info, png_bytep bytes)
{
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_init_io(png, file);
    png_set_IHDR(png, info, (png_uint_32)picture->width,
                 (png_uint_32)picture->height, 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    write_rows(picture, png, bytes);
    png_write_end(png, info);
    return true;
}

static bool write_png(const struct picture *picture, FILE *file)
{
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    png_bytep bytes = malloc(3 * (size_t)picture->width);
    const bool done =
        info && bytes && write_all(picture, file, png, info, bytes);
    png_destroy_write_struct(&png, &info);
    free(bytes);
    return done;
}

#endif

struct picture_format {
    const char *ending;
    bool (*write)(const struct picture *picture, FILE *file);
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

bool picture_save(const struct picture *picture, const char *path)
{
    struct output output;
    if (!picture_path_check(path) || !output_open(&output, path))
        return false;
    if (!format_of(path)->write(picture, output.stream)) {
        output_abandon(&output);
        return message_error_at(path, 0, "the picture cannot be written");
    }
    return output_commit(&output);
}

const char *picture_best_ending(void)
{
#ifdef HAVE_LIBPNG
    return ".png";
#else
    return ".bmp";
#endif
}
