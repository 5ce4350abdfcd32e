#include "sim/image/resize.h"

#include <math.h>
#include <stdlib.h>

#include "sim/cli/message.h"

#define LOBES 3
#define PI 3.14159265358979323846

static double lanczos(double x)
{
    if (fabs(x) < 1e-9)
        return 1;
    return fabs(x) >= LOBES
               ? 0
               : LOBES * sin(PI * x) * sin(PI * x / LOBES) / (PI * PI * x * x);
}

/* Premultiplied blue, green, red and alpha, rows or columns of them. */
struct plane {
    double (*at)[4];
    int width, height;
};

/* Beyond an edge the picture is mirrored at the middle of its last pixel. */
static int reflected(int i, int n)
{
    const int period = n > 1 ? 2 * n - 2 : 1;
    i = (i % period + period) % period;
    return i < n ? i : period - i;
}

/* Columns become others; the result is turned, so that twice is both ways. */
static bool resample(const struct plane *from, int width, struct plane *to)
{
    const double scale = (double)from->width / width;
    const double reach = LOBES * fmax(scale, 1);
    *to = (struct plane){
        calloc((size_t)width * (size_t)from->height, sizeof(*to->at)),
        from->height, width};
    if (!to->at)
        return message_error("no memory for a picture of %d x %d pixels", width,
                             from->height);
    for (int x = 0; x < width; x++) {
        const double middle = (x + 0.5) * scale - 0.5;
        double sum = 0;
        for (int i = (int)ceil(middle - reach); i <= middle + reach; i++) {
            const int source = reflected(i, from->width);
            const double weight = lanczos((i - middle) / fmax(scale, 1));
            sum += weight;
            for (int y = 0; y < from->height; y++)
                for (int k = 0; k < 4; k++)
                    to->at[(size_t)x * (size_t)to->width + (size_t)y][k] +=
                        weight * from->at[(size_t)y * (size_t)from->width +
                                          (size_t)source][k];
        }
        for (int y = 0; y < from->height; y++)
            for (int k = 0; k < 4; k++)
                to->at[(size_t)x * (size_t)to->width + (size_t)y][k] /= sum;
    }
    return true;
}

static unsigned byte_of(double v)
{
    return v > 0 ? v < 255 ? (unsigned)(v + 0.5) : 255 : 0;
}

static pel_color color_of(const double v[4])
{
    const unsigned alpha = byte_of(v[3]);
    const double part = alpha ? v[3] / 255 : 1;
    return alpha ? PEL_RGBA(byte_of(v[2] / part), byte_of(v[1] / part),
                            byte_of(v[0] / part), alpha)
                 : 0;
}

static bool premultiply(const struct picture *p, struct plane *to)
{
    const size_t n = (size_t)p->width * (size_t)p->height;
    *to = (struct plane){malloc(n * sizeof(*to->at)), p->width, p->height};
    for (size_t i = 0; to->at && i < n; i++) {
        const pel_color c = p->pixels[i];
        for (int k = 0; k < 4; k++)
            to->at[i][k] = k == 3 ? pel_alpha(c)
                                  : (c >> 8 * k & 255) * pel_alpha(c) / 255.0;
    }
    return to->at || message_error("no memory for %zu pixels", n);
}

bool picture_resize(struct picture *picture, int width, int height)
{
    struct plane whole = {NULL, 0, 0}, across = {NULL, 0, 0};
    struct plane down = {NULL, 0, 0};
    struct picture to = {0};
    if (width == picture->width && height == picture->height)
        return true;
    const bool done =
        premultiply(picture, &whole) && resample(&whole, width, &across) &&
        resample(&across, height, &down) && picture_init(&to, width, height, 0);
    for (size_t i = 0; done && i < (size_t)width * (size_t)height; i++)
        to.pixels[i] = color_of(down.at[i]);
    free(whole.at);
    free(across.at);
    free(down.at);
    if (!done)
        return false;
    picture_free(picture);
    *picture = to;
    return true;
}
