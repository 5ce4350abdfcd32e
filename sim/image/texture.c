#include "sim/image/texture.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#ifdef HAVE_SDL2_IMAGE
#include <SDL_image.h>
#endif

#include "sim/cli/bytes.h"
#include "sim/cli/child.h"
#include "sim/cli/message.h"
#include "sim/cli/text_line.h"
#include "sim/image/decode.h"

static bool begins(const struct encoded *from, const char *with)
{
    const size_t n = strlen(with);
    return from->size >= n && memcmp(from->bytes, with, n) == 0;
}

#ifdef HAVE_SDL2_IMAGE

/* ".tga" of the name; TGA has no signature. */
static const char *ending_of(const struct encoded *from)
{
    const char *dot = strrchr(from->name, '.');
    return dot && !strchr(dot, '/') ? dot : "";
}

static bool is_tga(const struct encoded *from)
{
    return path_has_ending(ending_of(from), " .tga ");
}

/* Width and height that a head claims, where they are near; false when not. */
static bool claimed_size(const struct encoded *from, uint32_t size[2])
{
    const size_t at = begins(from, "GIF8") ? 6 : is_tga(from) ? 12 : 0;
    for (int i = 0; at > 0 && from->size >= at + 4 && i < 2; i++)
        size[i] = bytes_little(from->bytes + at + 2 * (size_t)i, 2);
    return at > 0;
}

/* SDL_image takes what is missing at the end of a file as black. A reader that
 * reads beyond the end, and does not seek back, has read an incomplete file. */
static struct {
    size_t (*read)(SDL_RWops *, void *, size_t, size_t);
    Sint64 (*seek)(SDL_RWops *, Sint64, int);
    bool ended;
} reading; /* the one file of this process */

static size_t read_on(SDL_RWops *file, void *to, size_t size, size_t n)
{
    const size_t got = reading.read(file, to, size, n);
    reading.ended = reading.ended || (got == 0 && size * n > 0);
    return got;
}

static Sint64 go_to(SDL_RWops *file, Sint64 offset, int whence)
{
    reading.ended = false;
    return reading.seek(file, offset, whence);
}

static SDL_Surface *decode(const struct encoded *from)
{
    const char *ending = ending_of(from);
    SDL_RWops *file = SDL_RWFromConstMem(from->bytes, (int)from->size);
    if (!file)
        return NULL;
    reading.read = file->read;
    reading.seek = file->seek;
    file->read = read_on;
    file->seek = go_to;
    SDL_Surface *raw = IMG_LoadTyped_RW(file, 1, ending + (*ending != 0));
    SDL_Surface *image =
        raw ? SDL_ConvertSurfaceFormat(raw, SDL_PIXELFORMAT_ARGB8888, 0) : NULL;
    SDL_FreeSurface(raw);
    return image;
}

/* TGA, GIF and whatever else it knows. */
static bool decode_other(struct picture *picture, const struct encoded *from)
{
    uint32_t size[2] = {1, 1};
    const bool is_strict = claimed_size(from, size);
    if (!picture_size_check(from->name, size[0], size[1]))
        return false;
    const SDL_Surface *image = decode(from);
    if (!image)
        return message_error_at(from->name, 0,
                                "no picture that can be read (%s): expected a "
                                "PNG, JPEG, TGA, BMP or PPM file",
                                SDL_GetError());
    if (is_strict && reading.ended)
        return decode_refuse_end(from);
    if (!picture_size_check(from->name, image->w, image->h) ||
        !picture_init(picture, image->w, image->h, 0))
        return false;
    for (int y = 0; y < image->h; y++)
        memcpy(picture_row(picture, y),
               (const char *)image->pixels + (size_t)y * (size_t)image->pitch,
               sizeof(pel_color) * (size_t)image->w);
    return true;
}

#else

static bool decode_other(struct picture *picture, const struct encoded *from)
{
    (void)picture;
    return message_error_at(
        from->name, 0,
        "no PNG, JPEG, BMP or PPM file, and this pel was built without "
        "SDL2_image, which reads others: the package libsdl2-image-dev brings "
        "it");
}

#endif

bool decode_refuse_end(const struct encoded *from)
{
    return message_error_at(
        from->name, 0, "ends before its picture does: expected a whole file");
}

static bool is_ppm(const char *head, size_t n)
{
    return n > 2 && head[0] == 'P' && head[1] >= '1' && head[1] <= '7' &&
           (head[2] == '#' || (head[2] >= '\t' && head[2] <= ' '));
}

/* What a file is, its first bytes say. */
static bool decode_any(struct picture *picture, const struct encoded *from)
{
    return begins(from, "\x89PNG")    ? decode_png(picture, from)
           : begins(from, "\xFF\xD8") ? decode_jpeg(picture, from)
           : begins(from, "BM")       ? decode_bmp(picture, from)
                                      : decode_other(picture, from);
}

/* All bytes of a file. */
static bool read_bytes(struct encoded *from, FILE *file)
{
    from->bytes = (const uint8_t *)file_rest(file, &from->size);
    return from->bytes || file_refuse(from->name);
}

/* A PPM is read from the stream, which need not be in memory; the others are
 * decoded from their bytes. */
static bool read_picture(struct picture *picture, struct encoded *from)
{
    char head[3];
    FILE *file =
        from->bytes ? fmemopen((void *)(uintptr_t)from->bytes, from->size, "rb")
                    : file_open(from->name);
    if (!file)
        return false;
    const size_t n = fread(head, 1, sizeof head, file);
    for (size_t i = n; i > 0; i--)
        ungetc((unsigned char)head[i - 1], file);
    const bool done = is_ppm(head, n)
                          ? picture_read_ppm(picture, file, from->name)
                          : (from->bytes || read_bytes(from, file)) &&
                                decode_any(picture, from);
    fclose(file);
    return done;
}

/* Writes width and height, two int, and the pixels. The process ends after it,
 * and with it what it has taken. */
static bool put_picture(const void *what, FILE *out)
{
    struct encoded from = *(const struct encoded *)what;
    struct picture picture = {0};
    if (!read_picture(&picture, &from))
        return false;
    const int size[2] = {picture.width, picture.height};
    fwrite(size, sizeof size, 1, out);
    fwrite(picture.pixels, sizeof(pel_color) * (size_t)size[0], (size_t)size[1],
           out);
    return true;
}

static bool load(struct picture *picture, const struct encoded *from)
{
    int size[2];
    FILE *in = child_run(from->name, put_picture, from);
    *picture = (struct picture){0, 0, NULL};
    const bool done =
        in && fread(size, sizeof size, 1, in) == 1 &&
        picture_size_check(from->name, size[0], size[1]) &&
        picture_init(picture, size[0], size[1], 0) &&
        fread(picture->pixels, sizeof(pel_color) * (size_t)size[0],
              (size_t)size[1], in) == (size_t)size[1];
    if (in)
        fclose(in);
    return done;
}

bool texture_load_bytes(struct picture *picture, const char *name,
                        const void *bytes, size_t size)
{
    return load(picture, &(struct encoded){name, bytes, size});
}

bool texture_load(struct picture *picture, const char *path)
{
    *picture = (struct picture){0, 0, NULL};
    if (strcmp(path, "-") != 0 && access(path, R_OK) != 0)
        return message_error_at(path, 0, "cannot be read: %s", strerror(errno));
    return load(picture, &(struct encoded){path, NULL, 0});
}

/* Writes the number of colours, an int, and 256 colours. False with a message,
 * also where there is no palette. */
static bool put_palette(const void *what, FILE *out)
{
    struct encoded from = *(const struct encoded *)what;
    pel_color palette[256] = {0};
    FILE *file = file_open(from.name);
    if (!file || !read_bytes(&from, file))
        return false;
    const int n = begins(&from, "\x89PNG") ? decode_png_palette(&from, palette)
                  : begins(&from, "BM")    ? decode_bmp_palette(&from, palette)
                                           : 0;
    if (n <= 0)
        return n == 0 &&
               message_error_at(from.name, 0,
                                "has no palette of its own: expected a PNG "
                                "or BMP with one");
    fwrite(&n, sizeof n, 1, out);
    fwrite(palette, sizeof palette, 1, out);
    return true;
}

int texture_load_palette(const char *path, pel_color palette[256])
{
    int n = 0;
    FILE *in = child_run(path, put_palette, &(struct encoded){path, NULL, 0});
    if (in && (fread(&n, sizeof n, 1, in) != 1 ||
               fread(palette, 256 * sizeof *palette, 1, in) != 1))
        n = 0;
    if (in)
        fclose(in);
    return n;
}

bool texture_opaque(const struct picture *p)
{
    const size_t n = (size_t)p->width * (size_t)p->height;
    pel_color all = PEL_RGB(0, 0, 0);
    for (size_t i = 0; i < n; i++)
        all &= p->pixels[i];
    return pel_alpha(all) == 255;
}

/* floor(t n) for the fraction t of u: 1 - 2^-60 may round up to n. */
static int texel(double u, int n)
{
    int i = (int)((u - floor(u)) * n);
    return i < n ? i : n - 1;
}

pel_color texture_at(const struct picture *picture, double u, double v)
{
    int x = texel(u, picture->width), y = texel(v, picture->height);
    return picture_row(picture, y)[x] | PEL_RGB(0, 0, 0);
}
