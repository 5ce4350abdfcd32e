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

struct source {
    const char *name;  /* of the file */
    const void *bytes; /* that it has, or NULL: it is still to be read */
    size_t size;
};

#ifdef HAVE_SDL2_IMAGE

/* The first bytes of a file. */
struct head {
    uint8_t byte[26];
    const char *ending; /* of its name, ".tga", or ""; TGA has no signature */
};

static bool begins(const struct head *head, const char *with)
{
    return memcmp(head->byte, with, strlen(with)) == 0;
}

/* Width and height that a head claims, where they are near; false when not. */
static bool claimed_size(const struct head *head, uint32_t size[2])
{
    const uint8_t *byte = head->byte;
    const int bmp = byte[14] == 12 ? 2 : 4; /* bytes; 2 as OS/2 has it */
    for (int i = 0; i < 2; i++) {
        if (begins(head, "\x89PNG"))
            size[i] = bytes_big(byte + 16 + 4 * i, 4);
        else if (begins(head, "GIF8"))
            size[i] = bytes_little(byte + 6 + 2 * i, 2);
        else if (begins(head, "BM"))
            size[i] = bytes_little(byte + 18 + bmp * i, bmp);
        else if (path_has_ending(head->ending, " .tga "))
            size[i] = bytes_little(byte + 12 + 2 * i, 2);
        else
            return false;
    }
    if (size[1] >> 31) /* a BMP from the top */
        size[1] = -size[1];
    return true;
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

static SDL_RWops *open_source(const struct source *source)
{
    SDL_RWops *file = source->bytes
                          ? SDL_RWFromConstMem(source->bytes, (int)source->size)
                          : SDL_RWFromFile(source->name, "rb");
    if (!file)
        return NULL;
    reading.read = file->read;
    reading.seek = file->seek;
    file->read = read_on;
    file->seek = go_to;
    return file;
}

static SDL_Surface *decode(SDL_RWops *file, const char *ending)
{
    SDL_Surface *raw = file ? IMG_LoadTyped_RW(file, 1, ending) : NULL;
    SDL_Surface *image =
        raw ? SDL_ConvertSurfaceFormat(raw, SDL_PIXELFORMAT_ARGB8888, 0) : NULL;
    SDL_FreeSurface(raw);
    return image;
}

static void put_pixels(const SDL_Surface *image, FILE *out)
{
    const int size[2] = {image->w, image->h};
    fwrite(size, sizeof size, 1, out);
    for (int y = 0; y < image->h; y++)
        fwrite((const char *)image->pixels + (size_t)y * (size_t)image->pitch,
               sizeof(pel_color), (size_t)image->w, out);
}

/* Writes width and height, two int, and the pixels. The process ends after it,
 * and with it what it has taken. */
static bool put_picture(const void *what, FILE *out)
{
    const struct source *source = what;
    const char *name = source->name, *dot = strrchr(name, '.');
    struct head head = {.ending = dot && !source->bytes ? dot : ""};
    uint32_t size[2] = {1, 1};
    SDL_RWops *file = open_source(source);
    if (file && SDL_RWread(file, head.byte, 1, sizeof head.byte) > 0)
        SDL_RWseek(file, 0, RW_SEEK_SET);
    const bool is_strict =
        claimed_size(&head, size) || begins(&head, "\xFF\xD8");
    if (!picture_size_check(name, size[0], size[1]))
        return false;
    const SDL_Surface *image = decode(file, head.ending + (*head.ending != 0));
    if (!image)
        return message_error_at(name, 0,
                                "no picture that can be read (%s): expected a "
                                "PNG, JPEG, TGA, BMP or PPM file",
                                SDL_GetError());
    if (is_strict && reading.ended)
        return message_error_at(
            name, 0, "ends before its picture does: expected a whole file");
    if (!picture_size_check(name, image->w, image->h))
        return false;
    put_pixels(image, out);
    return true;
}

#else

static bool put_picture(const void *source, FILE *out)
{
    (void)out;
    return message_error_at(
        ((const struct source *)source)->name, 0,
        "this pel was built without SDL2_image and reads pictures as .ppm "
        "only; the package libsdl2-image-dev brings the others");
}

#endif

static bool load(struct picture *picture, const struct source *source)
{
    int size[2];
    FILE *in = child_run(source->name, put_picture, source);
    *picture = (struct picture){0, 0, NULL};
    const bool done =
        in && fread(size, sizeof size, 1, in) == 1 &&
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
    return load(picture, &(struct source){name, bytes, size});
}

bool texture_load(struct picture *picture, const char *path)
{
    *picture = (struct picture){0, 0, NULL};
    if (strcmp(path, "-") == 0 || path_has_ending(path, " .ppm .pgm "))
        return picture_load(picture, path);
    if (access(path, R_OK) != 0)
        return message_error_at(path, 0, "cannot be read: %s", strerror(errno));
    return load(picture, &(struct source){path, NULL, 0});
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
