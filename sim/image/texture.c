#include <errno.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "sim/cli/child.h"
#include "sim/cli/message.h"
#include "sim/image/texture_source.h"

static bool get_picture(struct picture *picture, FILE *in)
{
    int size[2];
    if (fread(size, sizeof size, 1, in) != 1 ||
        !picture_init(picture, size[0], size[1], 0))
        return false;
    const size_t n = (size_t)size[0] * (size_t)size[1];
    return fread(picture->pixels, sizeof(pel_color), n, in) == n;
}

static bool load(struct picture *picture, const struct texture_source *source)
{
    FILE *in = child_run(source->name, texture_put, source);
    const bool done = in && get_picture(picture, in);
    if (in)
        fclose(in);
    return done;
}

bool texture_load_bytes(struct picture *picture, const char *name,
                        const void *bytes, size_t size)
{
    const struct texture_source source = {name, bytes, size};
    memset(picture, 0, sizeof(*picture));
    return load(picture, &source);
}

static bool is_pnm(const char *path)
{
    const char *dot = strrchr(path, '.');
    return strcmp(path, "-") == 0 || (dot && strcmp(dot, ".ppm") == 0) ||
           (dot && strcmp(dot, ".pgm") == 0);
}

bool texture_load(struct picture *picture, const char *path)
{
    const struct texture_source source = {path, NULL, 0};
    memset(picture, 0, sizeof(*picture));
    if (is_pnm(path))
        return picture_load(picture, path);
    if (access(path, R_OK) != 0)
        return message_error_at(path, 0, "cannot be read: %s", strerror(errno));
    return load(picture, &source);
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
