/* The filler that owns the rows of a triangle through a depth buffer, against
 * the plain paint, byte for byte: small and large triangles one over the other,
 * flat and Gouraud, on all 32-bit formats with depths of 16 and 32 bits. */
#include <string.h>

#include "core/pel.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

enum { SIDE = 48, FENCE = 4, PIXELS = SIDE * SIDE + 2 * FENCE, LAYERS = 6 };

/* A picture and its depths, drawn with `fast` or without. */
struct picture {
    bool (*fast)(const struct pel_paint *paint,
                 const struct pel_surface *surface,
                 const struct pel_fast_triangle *triangle);
    uint32_t pixels[PIXELS], depths[PIXELS];
    struct pel_surface surface;
    struct pel_depth depth;
};

static uint64_t taken;

static bool count_fast(const struct pel_paint *paint,
                       const struct pel_surface *surface,
                       const struct pel_fast_triangle *triangle)
{
    const bool done = pel_depth_fast(paint, surface, triangle);
    taken += done;
    return done;
}

static struct picture pictures[2] = {{.fast = count_fast}, {.fast = NULL}};

static void open(struct picture *p, const struct pel_format *format, int bits)
{
    const struct pel_rect bounds = {-3, -5, SIDE - 3, SIDE - 5};
    memset(p->pixels, 0x5A, sizeof p->pixels);
    memset(p->depths, 0x5A, sizeof p->depths);
    assert_int_equal(pel_surface_init(&p->surface, format, p->pixels + FENCE,
                                      4 * SIDE * SIDE, &bounds),
                     PEL_OK);
    assert_int_equal(pel_depth_init(&p->depth, &bounds, bits, p->depths + FENCE,
                                    4 * SIDE * SIDE),
                     PEL_OK);
}

struct shape {
    struct pel_point v[3];
    pel_color color[3];
    int32_t near[3];
    bool gouraud;
};

static void make(struct random *r, struct shape *s)
{
    const int32_t size = random_between(r, 0, 2) ? PEL_PX(9) : PEL_PX(SIDE);
    const int32_t x = random_between(r, PEL_PX(-3), PEL_PX(SIDE - 3) - size);
    const int32_t y = random_between(r, PEL_PX(-5), PEL_PX(SIDE - 5) - size);
    s->gouraud = random_word(r) & 1;
    for (int k = 0; k < 3; k++) {
        s->v[k] = (struct pel_point){x + random_between(r, 0, size),
                                     y + random_between(r, 0, size)};
        s->color[k] = random_word(r) | UINT32_C(0xFF000000);
        s->near[k] = random_between(r, 1 << 14, PEL_DEPTH_NEAR);
    }
    shape_keep(s->v, 3);
}

static void draw(struct picture *p, const struct shape *s)
{
    struct pel_depth_paint paint;
    struct pel_plane_setup setup;
    struct pel_plane plane;
    struct pel_gouraud gouraud;
    struct pel_flat flat = PEL_FLAT(s->color[0]);
    pel_plane_start(&setup, s->v);
    pel_plane_set(&plane, &setup, s->near);
    pel_gouraud_init(&gouraud, s->v, s->color);
    pel_depth_paint_init(&paint, s->gouraud ? &gouraud.paint : &flat.paint,
                         &p->depth, &plane, true);
    paint.base.paint.fast = p->fast;
    pel_triangle(&p->surface, s->v, &paint.base.paint);
}

TEST(same_bytes)
{
    static const struct pel_format *const formats[] = {
        &pel_xrgb8888, &pel_bgrx8888, &pel_rgb565_le};
    uint64_t triangles = 0;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const uint32_t format = random_word(&c.random) % 8;
        const int bits = random_word(&c.random) & 1 ? 32 : 16;
        for (int k = 0; k < 2; k++)
            open(&pictures[k], formats[format < 3 ? format : 0], bits);
        for (int i = 0; i < LAYERS; i++, triangles++) {
            struct shape s;
            make(&c.random, &s);
            draw(&pictures[0], &s);
            draw(&pictures[1], &s);
        }
        if (memcmp(pictures[0].pixels, pictures[1].pixels,
                   sizeof pictures->pixels) ||
            memcmp(pictures[0].depths, pictures[1].depths,
                   sizeof pictures->depths))
            fail_msg("format %u, %d bits: bytes differ", format, bits);
    }
    assert_true(taken > triangles / 2);
}
