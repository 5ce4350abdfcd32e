#include "sim/image/texture_source.h"

#include "sim/cli/message.h"

#ifdef HAVE_SDL2_IMAGE
#include <SDL_image.h>
#include <string.h>
#include <strings.h>

#include "sim/cli/bytes.h"

/* The first bytes of a file. */
struct head {
    uint8_t byte[26];
    const char *ending; /* of its name, or ""; TGA has no signature */
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
        else if (strcasecmp(head->ending, "tga") == 0)
            size[i] = bytes_little(byte + 12 + 2 * i, 2);
        else
            return false;
    }
    if (size[1] >> 31) /* a BMP from the top */
        size[1] = -size[1];
    return true;
}

static bool check_size(const char *name, uint32_t width, uint32_t height)
{
    const uint32_t most = PICTURE_SIZE_MAX;
    return (width <= most && height <= most &&
            picture_size_legal((int)width, (int)height)) ||
           message_error_at(name, 0,
                            "a picture of %u x %u pixels: expected 1 to %d "
                            "each way, %d in all",
                            width, height, PICTURE_SIZE_MAX,
                            PICTURE_PIXELS_MAX);
}

/* SDL_image takes what is missing at the end of a file as black. A reader that
 * wants more than there is, and does not go back, has but a part. */
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

static SDL_RWops *open_source(const struct texture_source *source)
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

static bool put_pixels(const SDL_Surface *image, FILE *out)
{
    const int size[2] = {image->w, image->h};
    fwrite(size, sizeof size, 1, out);
    for (int y = 0; y < image->h; y++)
        fwrite((const char *)image->pixels + (size_t)y * (size_t)image->pitch,
               sizeof(pel_color), (size_t)image->w, out);
    return true;
}

/* The process ends after it, and with it what it has taken. */
bool texture_put(const void *what, FILE *out)
{
    const struct texture_source *source = what;
    const char *name = source->name, *dot = strrchr(name, '.');
    struct head head = {.ending = dot && !source->bytes ? dot + 1 : ""};
    uint32_t size[2] = {1, 1};
    SDL_RWops *file = open_source(source);
    if (file && SDL_RWread(file, head.byte, 1, sizeof head.byte) > 0)
        SDL_RWseek(file, 0, RW_SEEK_SET);
    const bool is_strict =
        claimed_size(&head, size) || begins(&head, "\xFF\xD8");
    if (!check_size(name, size[0], size[1]))
        return false;
    const SDL_Surface *image = decode(file, head.ending);
    if (!image)
        return message_error_at(name, 0,
                                "no picture that can be read (%s): expected a "
                                "PNG, JPEG, TGA, BMP or PPM file",
                                SDL_GetError());
    if (is_strict && reading.ended)
        return message_error_at(
            name, 0, "ends before its picture does: expected a whole file");
    return check_size(name, (uint32_t)image->w, (uint32_t)image->h) &&
           put_pixels(image, out);
}

#else

bool texture_put(const void *source, FILE *out)
{
    (void)out;
    return message_error_at(
        ((const struct texture_source *)source)->name, 0,
        "this pel was built without SDL2_image and reads pictures as .ppm "
        "only; the package libsdl2-image-dev brings the others");
}

#endif
