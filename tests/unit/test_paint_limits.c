/* Paints at the ends of what they take, and beyond. */
#include <string.h>

#include "tests/support/check.h"
#include "tests/support/hits.h"

union any_paint {
    struct pel_paint paint;
    struct pel_flat flat;
    struct pel_gouraud gouraud;
    struct pel_linear linear;
    struct pel_radial radial;
    struct pel_conic conic;
    struct pel_hue_wheel wheel;
    struct pel_fan fan;
    struct pel_texture texture;
    struct pel_dither dither;
};

static const struct pel_point inside = {0, 0}, outside = {INT32_MAX, 0};
static const struct pel_ramp no_ramp = {NULL, 2, PEL_PAD};

static enum pel_status gouraud(union any_paint *p)
{
    const struct pel_point v[3] = {outside, inside, inside};
    const pel_color c[3] = {1, 2, 3};
    return pel_gouraud_init(&p->gouraud, v, c);
}

static enum pel_status linear(union any_paint *p)
{
    return pel_linear_init(&p->linear, inside, outside, &no_ramp);
}

static enum pel_status radial(union any_paint *p)
{
    return pel_radial_init(&p->radial, NULL, &no_ramp);
}

static enum pel_status conic(union any_paint *p)
{
    return pel_conic_init(&p->conic, inside, 0, &no_ramp);
}

static enum pel_status wheel(union any_paint *p)
{
    return pel_hue_wheel_init(&p->wheel, outside, 0, 255, 255);
}

static enum pel_status fan(union any_paint *p)
{
    return pel_fan_init(&p->fan, NULL, NULL);
}

static enum pel_status nearest(union any_paint *p)
{
    return pel_texture_init_nearest(&p->texture, NULL, NULL);
}

static enum pel_status bilinear(union any_paint *p)
{
    const struct pel_texels none = {NULL, NULL, 1, 1, true};
    const struct pel_texture_map map = PEL_TEXTURE_AT(0, 0);
    return pel_texture_init_bilinear(&p->texture, &none, &map);
}

static enum pel_status dither(union any_paint *p)
{
    return pel_dither_init(&p->dither, NULL);
}

static enum pel_status dither_of_itself(union any_paint *p)
{
    return pel_dither_init(&p->dither, &p->paint);
}

static enum pel_status dither_of_a_dither(union any_paint *p)
{
    static const struct pel_flat flat = PEL_FLAT(PEL_RGB(1, 2, 3));
    struct pel_dither inner;
    assert_int_equal(pel_dither_init(&inner, &flat.paint), PEL_OK);
    return pel_dither_init(&p->dither, &inner.paint);
}

/* A paint whose init function failed draws nothing, whatever it was before. */
static void test_failed_paints(void **state)
{
    static enum pel_status (*const init[])(union any_paint *) = {
        gouraud,
        linear,
        radial,
        conic,
        wheel,
        fan,
        nearest,
        bilinear,
        dither,
        dither_of_itself,
        dither_of_a_dither};
    static uint32_t pixels[256];
    static const struct pel_rect bounds = {0, 0, 16, 16};
    const struct pel_point v[3] = {PEL_AT(0, 0), PEL_AT(16, 0), PEL_AT(0, 16)};
    const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    (void)state;
    for (size_t i = 0; i < sizeof init / sizeof *init; i++) {
        union any_paint p;
        struct pel_surface s;
        memset(&p, 0, sizeof p);
        p.flat = white;
        assert_int_equal(
            pel_surface_init_rect(&s, &pel_rgb565_le, pixels, 32, &bounds),
            PEL_OK);
        assert_true(init[i](&p) < 0);
        pel_triangle(&s, v, &p.paint);
        pel_circle(&s, v[0], PEL_PX(9), &p.paint);
        for (int k = 0; k < 256; k++)
            if (pixels[k])
                fail_msg("paint %zu draws", i);
    }
}

/* Coordinates at the ends of what fits show the picture's edge. */
static void test_ends_of_the_range(void **state)
{
    static const pel_color texels[4] = {1, 2, 3, 4};
    const struct pel_texels t = {NULL, texels, 2, 2, false};
    (void)state;
    for (int i = 0; i < 4; i++) {
        /* INT32_MIN texels, half a texel and the rounding of weights on */
        const uint64_t low = UINT64_C(0x800000007F800000);
        const struct pel_texture_plane u = {low - (uint64_t)(i & 1), 0, 0};
        const struct pel_texture_plane v = {low - (uint64_t)(i >> 1), 0, 0};
        const struct pel_texture_map map = {u, v};
        struct pel_texture p;
        pel_color got;
        assert_int_equal(pel_texture_init_bilinear(&p, &t, &map), PEL_OK);
        p.base.colors(&p.base, 0, 0, 1, &got);
        assert_int_equal(got, texels[i]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_failed_paints),
        cmocka_unit_test(test_ends_of_the_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
