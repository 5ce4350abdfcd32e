#include "sim/image/texture.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "sim/cli/message.h"

#ifdef HAVE_SDL2_IMAGE
#include <SDL_image.h>

static bool copy_surface(struct picture *picture, SDL_Surface *image)
{
    if (!picture_init(picture, image->w, image->h, 0))
        return false;
    for (int y = 0; y < image->h; y++)
        memcpy(picture_row(picture, y),
               (const char *)image->pixels + (size_t)y * (size_t)image->pitch,
               (size_t)image->w * sizeof(pel_color));
    return true;
}

/* Takes `raw` over; NULL is the failure that IMG_GetError() tells. `ending`
 * names formats without a signature (TGA), NULL when unknown. */
static bool load(struct picture *picture, const char *name, SDL_RWops *source,
                 const char *ending)
{
    SDL_Surface *raw =
        source ? IMG_LoadTyped_RW(source, 1, ending ? ending : "") : NULL;
    SDL_Surface *image =
        raw ? SDL_ConvertSurfaceFormat(raw, SDL_PIXELFORMAT_ARGB8888, 0) : NULL;
    bool done;
    if (image)
        done = copy_surface(picture, image);
    else
        done = message_error_at(name, 0,
                                "no picture that can be read (%s); a PNG, "
                                "JPEG, TGA, BMP or PPM file would be right",
                                SDL_GetError());
    SDL_FreeSurface(image);
    SDL_FreeSurface(raw);
    return done;
}

static bool load_file(struct picture *picture, const char *path)
{
    const char *dot = strrchr(path, '.');
    if (access(path, R_OK) != 0)
        return message_error_at(path, 0, "cannot be read: %s", strerror(errno));
    return load(picture, path, SDL_RWFromFile(path, "rb"), dot ? dot + 1 : "");
}

bool texture_load_bytes(struct picture *picture, const char *name,
                        const void *bytes, size_t size)
{
    memset(picture, 0, sizeof(*picture));
    if (size > INT32_MAX)
        return message_error_at(name, 0, "its texture is larger than 2 GB");
    return load(picture, name, SDL_RWFromConstMem(bytes, (int)size), NULL);
}

#else

static bool load_file(struct picture *picture, const char *path)
{
    (void)picture;
    return message_error_at(path, 0,
                            "this pel was built without SDL2_image and reads "
                            "pictures as .ppm only; the package "
                            "libsdl2-image-dev brings the others");
}

bool texture_load_bytes(struct picture *picture, const char *name,
                        const void *bytes, size_t size)
{
    (void)bytes;
    (void)size;
    memset(picture, 0, sizeof(*picture));
    return load_file(picture, name);
}

#endif

static bool is_pnm(const char *path)
{
    const char *dot = strrchr(path, '.');
    return strcmp(path, "-") == 0 || (dot && strcmp(dot, ".ppm") == 0) ||
           (dot && strcmp(dot, ".pgm") == 0);
}

bool texture_load(struct picture *picture, const char *path)
{
    memset(picture, 0, sizeof(*picture));
    return is_pnm(path) ? picture_load(picture, path)
                        : load_file(picture, path);
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
