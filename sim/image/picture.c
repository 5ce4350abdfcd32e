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

/* The first three channels as bytes, red first, malloc'ed. */
static unsigned char *bytes_of(const struct picture *picture)
{
    const size_t n = (size_t)picture->width * (size_t)picture->height;
    unsigned char *bytes = malloc(3 * n), *to = bytes;
    for (size_t i = 0; bytes && i < n; i++) {
        *to++ = (unsigned char)pel_red(picture->pixels[i]);
        *to++ = (unsigned char)pel_green(picture->pixels[i]);
        *to++ = (unsigned char)pel_blue(picture->pixels[i]);
    }
    return bytes;
}

static bool write_ppm(const struct picture *p, FILE *file,
                      const unsigned char *bytes)
{
    fprintf(file, "P6\n%d %d\n255\n", p->width, p->height);
    fwrite(bytes, 3 * (size_t)p->width, (size_t)p->height, file);
    return true;
}

static void put32(unsigned char *to, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        to[i] = (unsigned char)(v >> 8 * i & 255);
}

/* A picture at the limit has 32,767 x 98,304 bytes: below 2^32. */
static bool write_bmp(const struct picture *p, FILE *file,
                      const unsigned char *bytes)
{
    enum { FILE_HEADER = 14, INFO_HEADER = 40, HEADERS = 54 };
    const size_t row = 3 * (size_t)p->width, padding = (size_t)p->width % 4;
    const uint32_t size = (uint32_t)((row + padding) * (size_t)p->height);
    unsigned char h[HEADERS] = {'B', 'M', [26] = 1, [28] = 24};
    put32(h + 2, HEADERS + size);
    put32(h + 10, HEADERS);
    put32(h + FILE_HEADER, INFO_HEADER);
    put32(h + 18, (uint32_t)p->width);
    put32(h + 22, (uint32_t)p->height);
    put32(h + 34, size);
    fwrite(h, 1, sizeof h, file);
    for (size_t y = (size_t)p->height; y-- > 0;) {
        const unsigned char *rgb = bytes + y * row;
        for (const unsigned char *end = rgb + row; rgb < end; rgb += 3) {
            putc_unlocked(rgb[2], file);
            putc_unlocked(rgb[1], file);
            putc_unlocked(rgb[0], file);
        }
        fwrite("\0\0", 1, padding, file);
    }
    return true;
}

#ifdef HAVE_LIBPNG

static bool write_png(const struct picture *p, FILE *file,
                      const unsigned char *bytes)
{
    png_image image = {.version = PNG_IMAGE_VERSION,
                       .width = (png_uint_32)p->width,
                       .height = (png_uint_32)p->height,
                       .format = PNG_FORMAT_RGB};
    return png_image_write_to_stdio(&image, file, 0, bytes, 0, NULL);
}

#endif

struct picture_format {
    const char *ending;
    bool (*write)(const struct picture *picture, FILE *file,
                  const unsigned char *bytes);
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
    unsigned char *bytes = bytes_of(picture);
    const bool done =
        bytes && format_of(path)->write(picture, output.stream, bytes);
    free(bytes);
    if (done)
        return output_commit(&output);
    output_abandon(&output);
    return message_error_at(path, 0, "the picture cannot be written");
}

const char *picture_best_ending(void)
{
#ifdef HAVE_LIBPNG
    return ".png";
#else
    return ".bmp";
#endif
}
