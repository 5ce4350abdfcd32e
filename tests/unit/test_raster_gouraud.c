/* Single facts about interpolated colors. */
#define _DEFAULT_SOURCE /* alarm */
#include <string.h>
#include <unistd.h>

#include "tests/support/canvas.h"
#include "tests/support/check.h"

/* Wider than the buffers of colors. */
static const struct pel_rect bounds = {0, 0, 80, 8};

/* Planes that reach the next step exactly at pixel `cross`: the last of their
 * 24 bits decides, in every lane of a vector. */
static void check_last_bit(struct canvas *canvas, uint32_t dx, uint32_t cross)
{
    static const struct pel_point v[3] = {PEL_AT(0, 0), PEL_AT(200, 0),
                                          PEL_AT(0, 8)};
    const pel_color white[3] = {0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF};
    struct pel_gouraud g;
    assert_int_equal(pel_gouraud_init(&g, v, white), PEL_OK);
    for (int k = 0; k < 3; k++) {
        g.at[k] = 0x05000000u - cross * dx;
        g.dx[k] = dx;
    }
    canvas_open(canvas, &pel_xrgb8888, &bounds, 0);
    pel_triangle(&canvas->surface, v, &g.paint);
    const uint8_t *row = canvas->surface.pixels;
    for (uint32_t x = 0; x < 40; x++)
        for (int k = 0; k < 3; k++)
            if (row[4 * x + (uint32_t)k] != (g.at[k] + x * dx) >> 24)
                fail_msg("step %u, crossing at %u: pixel %u", dx, cross, x);
}

TEST(last_bit_counts)
{
    static struct canvas canvas;
    for (uint32_t cross = 0; cross < 16; cross++) {
        check_last_bit(&canvas, 1, cross);
        check_last_bit(&canvas, 0x10001, cross);
        check_last_bit(&canvas, 0xFFFFFFFF, cross);
    }
}

/* A triangle without area covers nothing, and its set-up ends. */
TEST(one_point_three_times)
{
    static struct canvas canvas;
    const pel_color c[3] = {PEL_RGB(1, 2, 3), PEL_RGB(40, 50, 60), 0};
    static const struct pel_point v[][3] = {
        {{5, 5}, {5, 5}, {5, 5}},
        {{128, 128}, {128, 128}, {128, 128}},
        {{PEL_COORDINATE_MIN, PEL_COORDINATE_MIN},
         {PEL_COORDINATE_MIN, PEL_COORDINATE_MIN},
         {PEL_COORDINATE_MIN, PEL_COORDINATE_MIN}},
        {{0, 0}, {0, 0}, {256, 256}},
        {{0, 0}, {1024, 1024}, {512, 512}},
    };
    alarm(10);
    for (size_t i = 0; i < sizeof v / sizeof v[0]; i++) {
        canvas_open(&canvas, &pel_xrgb8888, &bounds, 0);
        pel_triangle_gouraud(&canvas.surface, v[i], c);
        assert_memory_equal(canvas.memory, canvas.before, canvas.size);
    }
    alarm(0);
}

/* Alpha 0 leaves the pixel untouched, bits that no color uses included. */
TEST(alpha_0_touches_nothing)
{
    static struct canvas canvas;
    static const struct pel_point v[3] = {PEL_AT(-1, -1), PEL_AT(200, 0),
                                          PEL_AT(0, 20)};
    const pel_color c[3] = {0x00FF0000, 0x0000FF00, 0x000000FF};
    for (int f = 0; f < LAYOUT_COUNT; f++) {
        canvas_open(&canvas, layouts[f].format, &bounds, 0);
        pel_triangle_gouraud(&canvas.surface, v, c);
        if (memcmp(canvas.memory, canvas.before, canvas.size) != 0)
            fail_msg("%s: alpha 0 changed a pixel", layouts[f].name);
    }
}

/* Equal colors are that color, exactly, wherever the vertices are. */
TEST(equal_colors_are_flat)
{
    static struct canvas smooth, flat;
    static const struct pel_point v[3] = {
        {-8388608, -7000000}, {8388607, 100}, {-500, 8388607}};
    for (int f = 0; f < LAYOUT_COUNT; f++)
        for (uint32_t a = 0; a < 256; a += 51) {
            const struct pel_flat paint = PEL_FLAT(a << 24 | 0x123456u);
            const pel_color c[3] = {paint.color, paint.color, paint.color};
            canvas_open(&smooth, layouts[f].format, &bounds, 0);
            canvas_open(&flat, layouts[f].format, &bounds, 0);
            pel_triangle_gouraud(&smooth.surface, v, c);
            pel_triangle(&flat.surface, v, &paint.paint);
            if (memcmp(smooth.memory, flat.memory, flat.size) != 0)
                fail_msg("%s, alpha %u", layouts[f].name, a);
        }
}

TEST(what_is_refused)
{
    struct pel_gouraud g;
    static const struct pel_point v[3] = {PEL_AT(0, 0), PEL_AT(9, 0),
                                          PEL_AT(0, 9)};
    static const struct pel_point far[3] = {
        PEL_AT(0, 0), PEL_AT(9, 0), {0, PEL_COORDINATE_MAX + 1}};
    static const pel_color c[3] = {1, 2, 3};
    assert_int_equal(pel_gouraud_init(&g, v, c), PEL_OK);
    assert_int_equal(pel_gouraud_init(NULL, v, c), PEL_ERROR_NULL);
    assert_int_equal(pel_gouraud_init(&g, NULL, c), PEL_ERROR_NULL);
    assert_int_equal(pel_gouraud_init(&g, v, NULL), PEL_ERROR_NULL);
    assert_int_equal(pel_gouraud_init(&g, far, c), PEL_ERROR_RANGE);
}

static void put_fails(const struct pel_surface *surface, int32_t x, int32_t y,
                      int32_t n, const pel_color *colors)
{
    (void)surface;
    (void)x;
    (void)y;
    (void)n;
    (void)colors;
    fail_msg("runs went through the buffer");
}

/* Opaque colors of a clipped triangle go straight into the pixels. */
TEST(runs_are_direct)
{
    static const struct pel_point v[3] = {PEL_AT(-1, -1), PEL_AT(200, 0),
                                          PEL_AT(0, 20)};
    static const pel_color c[3] = {PEL_RGB(0, 0, 0), PEL_RGB(1, 2, 3),
                                   PEL_RGB(255, 255, 255)};
    static uint32_t pixels[64];
    struct pel_format formats[2] = {pel_rgb565_le, pel_xrgb8888};
    struct pel_surface s;
    for (int f = 0; f < (PEL_FAST_FILLS ? 2 : 1); f++) {
        formats[f].put = put_fails;
        s = surface_of(&formats[f], pixels, sizeof pixels, 8, 8);
        pel_triangle_gouraud(&s, v, c);
    }
}

/* A format of one's own may have channels without a writer of planes. */
TEST(channels_without_planes)
{
    static struct canvas canvas[2];
    static const struct pel_point v[3] = {PEL_AT(-1, -1), PEL_AT(200, 0),
                                          PEL_AT(0, 20)};
    static const pel_color c[3] = {PEL_RGB(0, 0, 0), PEL_RGB(1, 200, 3),
                                   PEL_RGB(255, 255, 255)};
    int found = 0;
    for (int f = 0; f < LAYOUT_COUNT; f++) {
        struct pel_format own = *layouts[f].format;
        if (!own.channels)
            continue;
        struct pel_channels channels = *own.channels;
        found++;
        channels.planes = NULL;
        own.channels = &channels;
        for (int i = 0; i < 2; i++) {
            canvas_open(&canvas[i], layouts[f].format, &bounds, 0);
            if (i > 0)
                canvas[i].surface.format = &own;
            pel_triangle_gouraud(&canvas[i].surface, v, c);
        }
        canvas_check_same(&canvas[0], &canvas[1]);
    }
    assert_true(found > 0);
}
