#include "sim/image/picture.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "sim/cli/message.h"
#include "sim/cli/output.h"
#include "sim/image/picture_file.h"

bool picture_size_legal(int width, int height)
{
    return width >= 1 && height >= 1 && width <= PICTURE_SIZE_MAX &&
           height <= PICTURE_SIZE_MAX && width <= PICTURE_PIXELS_MAX / height;
}

bool picture_init(struct picture *picture, int width, int height,
                  pel_color color)
{
    const struct picture empty = {0, 0, NULL};
    *picture = empty;
    if (!picture_size_legal(width, height))
        return message_error("a picture of %d x %d pixels: 1 to %d each way, "
                             "%d in all",
                             width, height, PICTURE_SIZE_MAX,
                             PICTURE_PIXELS_MAX);
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
    const struct picture empty = {0, 0, NULL};
    free(picture->pixels);
    *picture = empty;
}

void picture_bytes(const struct picture *picture, int y, unsigned char *to)
{
    const pel_color *row = picture_row(picture, y);
    for (int x = 0; x < picture->width; x++) {
        *to++ = (unsigned char)pel_red(row[x]);
        *to++ = (unsigned char)pel_green(row[x]);
        *to++ = (unsigned char)pel_blue(row[x]);
    }
}

bool picture_load(struct picture *picture, const char *path)
{
    const struct picture empty = {0, 0, NULL};
    *picture = empty;
    if (strcmp(path, "-") == 0)
        return picture_read_ppm(picture, stdin, path);
    FILE *file = fopen(path, "rb");
    if (!file)
        return message_error_at(path, 0, "cannot be read: %s", strerror(errno));
    const bool done = picture_read_ppm(picture, file, path);
    fclose(file);
    return done;
}

struct picture_format {
    const char *ending;
    bool (*write)(const struct picture *picture, FILE *file);
};

static const struct picture_format formats[] = {
    {".ppm", picture_write_ppm},
    {".bmp", picture_write_bmp},
#ifdef HAVE_LIBPNG
    {".png", picture_write_png},
#endif
    {NULL, NULL},
};

static bool has_ending(const char *path, const char *ending)
{
    const size_t n = strlen(path), m = strlen(ending);
    return n > m && strcasecmp(path + n - m, ending) == 0;
}

static const struct picture_format *format_of(const char *path)
{
    const struct picture_format *format = formats;
    if (strcmp(path, "-") == 0)
        return format;
    while (format->ending && !has_ending(path, format->ending))
        format++;
    return format->ending ? format : NULL;
}

bool picture_path_check(const char *path)
{
    if (format_of(path))
        return true;
    if (has_ending(path, ".png"))
        return message_error_at(path, 0,
                                "this pel was built without libpng: install "
                                "libpng-dev and pkg-config and build again, "
                                "or write .ppm or .bmp");
    return message_error_at(path, 0,
                            "unknown picture format: the name must end in "
                            ".ppm, .bmp or .png");
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
