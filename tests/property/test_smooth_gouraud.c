/* Smooth Gouraud triangles: full pixels as without smoothing, byte for byte;
 * those at an edge in the color of the plane at their centre, cut to 0..255. */
#include <string.h>

#include "core/pel.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"
#include "tests/support/shapes.h"

enum { SIZE = 24 };

static uint32_t smooth[SIZE * SIZE], plain[SIZE * SIZE];
static uint8_t coverage[SIZE * SIZE];
static struct pel_point v[3];
static pel_color c[3];

static struct pel_surface open_surface(const struct pel_format *format,
                                       void *memory, size_t size,
                                       const struct pel_rect *bounds)
{
    struct pel_surface s;
    memset(memory, 0, size);
    assert_int_equal(pel_surface_init(&s, format, memory, size, bounds),
                     PEL_OK);
    return s;
}

/* 0..255 at the centre of a pixel. */
static long double exact_channel(int32_t x, int32_t y, int k)
{
    const long double area = (long double)pel_triangle_area(v);
    const struct pel_point at = {pel_pixel_center(x), pel_pixel_center(y)};
    long double value = 0;
    for (int i = 0; i < 3; i++) {
        struct pel_point t[3] = {v[0], v[1], v[2]};
        t[i] = at;
        value +=
            (long double)pel_triangle_area(t) / area * (c[i] >> 8 * k & 255);
    }
    return value < 0 ? 0 : value > 255 ? 255 : value;
}

static void check_edge(uint32_t got, uint32_t weight, int32_t x, int32_t y)
{
    for (int k = 0; k < 3; k++) {
        const long double off =
            (got >> 8 * k & 255) - exact_channel(x, y, k) * weight / 255;
        if (off > 1.51L || off < -1.51L)
            fail_msg("(%d, %d) channel %d: %u, off by %.3Lf: %s", x, y, k,
                     got >> 8 * k & 255, off, cases_replay());
    }
}

static void check_pixels(const struct pel_rect *b)
{
    const bool sliver = pel_size_of(pel_triangle_area(v)) < 65536;
    const int32_t width = b->x1 - b->x0, n = width * (b->y1 - b->y0);
    for (int32_t i = 0; i < n; i++) {
        if (coverage[i] == 255)
            assert_int_equal(smooth[i], plain[i]);
        else if (coverage[i] == 0)
            assert_int_equal(smooth[i], 0);
        else if (!sliver)
            check_edge(smooth[i], coverage[i], b->x0 + i % width,
                       b->y0 + i / width);
    }
}

TEST(colors)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    for (struct cases cases = cases_of(200000); cases_next(&cases);) {
        struct random *r = &cases.random;
        if (random_word(r) % 4)
            shape_random(r, v, 3);
        else
            shape_adversarial(r, v, 3);
        for (int i = 0; i < 3; i++)
            c[i] = random_word(r) | 0xFF000000u;
        const struct pel_rect b = shape_window(r, v, 3, SIZE);
        struct pel_surface s =
            open_surface(&pel_xrgb8888, smooth, sizeof smooth, &b);
        pel_smooth_triangle_gouraud(&s, v, c);
        s = open_surface(&pel_xrgb8888, plain, sizeof plain, &b);
        pel_triangle_gouraud(&s, v, c);
        s = open_surface(&pel_gray8, coverage, sizeof coverage, &b);
        pel_smooth_triangle(&s, v, &white.paint);
        check_pixels(&b);
    }
}
