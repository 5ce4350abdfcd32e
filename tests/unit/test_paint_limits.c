/* Paints at the ends of what they take, and beyond: which errors they give. */
#include <string.h>

#include "tests/support/any_paint.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"

/* The i-th way in which the init function of a paint fails. */
enum { FAILURES = 15 };

static enum pel_status fail_init(int i, union any_paint *p)
{
    static const struct pel_point inside = {0, 0}, outside = {INT32_MAX, 0};
    static const struct pel_point v[3] = {{INT32_MAX, 0}};
    static const pel_color c[3] = {1, 2, 3};
    static const struct pel_ramp no_ramp = {NULL, 2, PEL_PAD};
    static const struct pel_flat flat = PEL_FLAT(PEL_RGB(1, 2, 3));
    static const struct pel_texels none = {NULL, NULL, 1, 1, true};
    static const struct pel_texture_map map = PEL_TEXTURE_AT(0, 0);
    struct pel_dither inner;
    switch (i) {
    case 0:
        return pel_gouraud_init(&p->gouraud, v, c);
    case 1:
        return pel_linear_init(&p->linear, inside, outside, &no_ramp);
    case 2:
        return pel_radial_init(&p->radial, NULL, &no_ramp);
    case 3:
        return pel_conic_init(&p->conic, inside, 0, &no_ramp);
    case 4:
        return pel_hue_wheel_init(&p->wheel, outside, 0, 255, 255);
    case 5:
        return pel_fan_init(&p->fan, NULL, NULL);
    case 6:
        return pel_texture_init_nearest(&p->texture, NULL, NULL);
    case 7:
        return pel_texture_init_bilinear(&p->texture, &none, &map);
    case 8:
        return pel_dither_init(&p->dither, NULL);
    case 9:
        return pel_dither_init(&p->dither, &p->paint);
    case 10:
        return pel_blend_init(&p->blend, &p->paint, PEL_BLEND_XOR);
    case 11:
        return pel_checker_init(&p->checker, NULL, 0, 0);
    case 12:
        return pel_hatch_init(&p->hatch, NULL, 0, 0);
    case 13:
        return pel_nine_slice_init(&p->slices, NULL, NULL, NULL);
    default:
        assert_int_equal(pel_dither_init(&inner, &flat.paint), PEL_OK);
        return pel_dither_init(&p->dither, &inner.paint);
    }
}

/* A paint whose init function failed draws nothing, whatever it was before. */
TEST(failed_paints)
{
    static uint32_t pixels[256];
    static const struct pel_rect bounds = {0, 0, 16, 16};
    const struct pel_point v[3] = {PEL_AT(0, 0), PEL_AT(16, 0), PEL_AT(0, 16)};
    const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    for (int i = 0; i < FAILURES; i++) {
        union any_paint p;
        struct pel_surface s;
        memset(&p, 0, sizeof p);
        p.flat = white;
        assert_int_equal(
            pel_surface_init_rect(&s, &pel_rgb565_le, pixels, 32, &bounds),
            PEL_OK);
        assert_true(fail_init(i, &p) < 0);
        pel_triangle(&s, v, &p.paint);
        pel_circle(&s, v[0], PEL_PX(9), &p.paint);
        for (int k = 0; k < 256; k++)
            if (pixels[k])
                fail_msg("paint %d draws", i);
    }
    struct pel_dither d;
    assert_int_equal(pel_dither_init(NULL, &white.paint), PEL_ERROR_NULL);
    assert_int_equal(pel_dither_init(&d, NULL), PEL_ERROR_NULL);
}

/* Coordinates at the ends of what fits show the picture's edge. */
TEST(ends_of_the_range)
{
    static const pel_color texels[4] = {1, 2, 3, 4};
    const struct pel_texels t = {NULL, texels, 2, 2, false};
    for (int i = 0; i < 4; i++) {
        /* INT32_MIN texels, half a texel and the rounding of weights on */
        const uint64_t low = UINT64_C(0x800000007F800000);
        const struct pel_plane u = {low - (uint64_t)(i & 1), 0, 0};
        const struct pel_plane v = {low - (uint64_t)(i >> 1), 0, 0};
        const struct pel_texture_map map = {u, v};
        struct pel_texture p;
        pel_color got;
        assert_int_equal(pel_texture_init_bilinear(&p, &t, &map), PEL_OK);
        p.base.colors(&p.base, 0, 0, 1, &got);
        assert_int_equal(got, texels[i]);
    }
}

TEST(errors_of_gradients)
{
    static const pel_color two[2];
    const struct pel_point at = {0, 0}, to = {1, 0};
    const struct pel_point out = {PEL_COORDINATE_MAX + 1, 0};
    const struct pel_ramp good = {two, 2, PEL_PAD}, none = {two, 0, PEL_PAD},
                          many = {two, 32768, PEL_PAD}, null = {NULL, 2, 0};
    struct pel_linear l;
    struct pel_radial radial;
    struct pel_conic conic;
    struct pel_hue_wheel wheel;
    const struct {
        const struct pel_ramp *ramp;
        struct pel_point at;
        int32_t radius;
        enum pel_status linear, radial, conic;
    } rows[] = {
        {&good, at, 256, PEL_OK, PEL_OK, PEL_OK},
        {NULL, at, 256, PEL_ERROR_NULL, PEL_ERROR_NULL, PEL_ERROR_NULL},
        {&null, at, 256, PEL_ERROR_NULL, PEL_ERROR_NULL, PEL_ERROR_NULL},
        {&none, at, 256, PEL_ERROR_SIZE, PEL_ERROR_SIZE, PEL_ERROR_SIZE},
        {&many, at, 256, PEL_ERROR_SIZE, PEL_ERROR_SIZE, PEL_ERROR_SIZE},
        {&good, out, 256, PEL_ERROR_RANGE, PEL_ERROR_RANGE, PEL_ERROR_RANGE},
        {&good, to, 255, PEL_ERROR_SIZE, PEL_ERROR_RANGE, PEL_OK},
        {&good, to, PEL_PX(32767) + 1, PEL_ERROR_SIZE, PEL_ERROR_RANGE, PEL_OK},
    };
    for (unsigned i = 0; i < sizeof rows / sizeof *rows; i++) {
        const struct pel_rings rings = {rows[i].at, rows[i].radius, 0};
        const struct pel_ramp *ramp = rows[i].ramp;
        assert_int_equal(pel_linear_init(&l, rows[i].at, to, ramp),
                         rows[i].linear);
        assert_int_equal(pel_radial_init(&radial, &rings, ramp),
                         rows[i].radial);
        assert_int_equal(pel_conic_init(&conic, rows[i].at, 0, ramp),
                         rows[i].conic);
        assert_int_equal(pel_linear_init(NULL, rows[i].at, to, ramp),
                         PEL_ERROR_NULL);
        assert_int_equal(pel_radial_init(NULL, &rings, ramp), PEL_ERROR_NULL);
        assert_int_equal(pel_conic_init(NULL, rows[i].at, 0, ramp),
                         PEL_ERROR_NULL);
    }
    assert_int_equal(pel_linear_init(&l, at, out, &good), PEL_ERROR_RANGE);
    assert_int_equal(pel_radial_init(&radial, NULL, &good), PEL_ERROR_NULL);
    assert_int_equal(pel_hue_wheel_init(NULL, at, 0, 1, 2), PEL_ERROR_NULL);
    assert_int_equal(pel_hue_wheel_init(&wheel, out, 0, 1, 2), PEL_ERROR_RANGE);
}

TEST(errors_of_textures)
{
    const struct pel_texture_map map = PEL_TEXTURE_AT(0, 0);
    const pel_color one = 0;
    struct pel_texels t = {NULL, &one, 1, 1, false};
    struct pel_texture p;
    struct pel_texture_map m;
    struct pel_surface surface;
    uint16_t words[2] = {0, 0};
    struct pel_point v[3] = {PEL_AT(0, 0), PEL_AT(1, 0), PEL_AT(0, 1)};
    const struct pel_texel_point q[3] = {{0, 0}, {1, 0}, {0, 1}};
    assert_int_equal(pel_texture_init_nearest(NULL, &t, &map), PEL_ERROR_NULL);
    assert_int_equal(pel_texture_init_nearest(&p, NULL, &map), PEL_ERROR_NULL);
    assert_int_equal(pel_texture_init_bilinear(&p, &t, NULL), PEL_ERROR_NULL);
    t.width = 0;
    assert_int_equal(pel_texture_init_nearest(&p, &t, &map), PEL_ERROR_SIZE);
    t.width = 1;
    t.height = 32768;
    assert_int_equal(pel_texture_init_bilinear(&p, &t, &map), PEL_ERROR_SIZE);
    t.colors = NULL;
    assert_int_equal(pel_texture_init_nearest(&p, &t, &map), PEL_ERROR_NULL);
    const struct pel_rect two = {0, 0, 2, 1};
    pel_surface_init(&surface, &pel_rgb565_le_fill, words, sizeof words, &two);
    t.surface = &surface;
    assert_int_equal(pel_texture_init_nearest(&p, &t, &map), PEL_ERROR_FORMAT);
    assert_int_equal(pel_texture_map_triangle(&m, NULL, q), PEL_ERROR_NULL);
    v[1].x = PEL_COORDINATE_MAX + 1;
    assert_int_equal(pel_texture_map_triangle(&m, v, q), PEL_ERROR_RANGE);
}

TEST(errors_of_fans)
{
    static struct pel_fan_triangle memory[5];
    struct pel_fan fan;
    const struct pel_point far[3] = {
        PEL_AT(0, 0), PEL_AT(20, 0), {PEL_PX(10), PEL_COORDINATE_MAX + 1}};
    const struct pel_point v[4] = {PEL_AT(0, 0), PEL_AT(20, 0), PEL_AT(10, 10),
                                   PEL_AT(-5, 3)};
    const pel_color c[4] = {0, 0, 0, 0};
    struct pel_fan_points p = {PEL_AT(10, 3), 0, v, c, 3};
    assert_int_equal(pel_fan_init(&fan, &p, memory), PEL_OK);
    assert_int_equal(pel_fan_init(NULL, &p, memory), PEL_ERROR_NULL);
    assert_int_equal(pel_fan_init(&fan, &p, NULL), PEL_ERROR_NULL);
    assert_int_equal(pel_fan_init(&fan, NULL, memory), PEL_ERROR_NULL);
    p.colors = NULL;
    assert_int_equal(pel_fan_init(&fan, &p, memory), PEL_ERROR_NULL);
    p.colors = c;
    p.perimeter = NULL;
    assert_int_equal(pel_fan_init(&fan, &p, memory), PEL_ERROR_NULL);
    p.perimeter = far;
    assert_int_equal(pel_fan_init(&fan, &p, memory), PEL_ERROR_RANGE);
    p.perimeter = v;
    p.n = 2;
    assert_int_equal(pel_fan_init(&fan, &p, memory), PEL_ERROR_SIZE);
    /* A star of five points in one line goes around its middle twice. */
    const struct pel_point star[5] = {PEL_AT(0, -20), PEL_AT(12, 16),
                                      PEL_AT(-19, -6), PEL_AT(19, -6),
                                      PEL_AT(-12, 16)};
    const pel_color hues[5] = {0, 0, 0, 0, 0};
    const struct pel_fan_points twice = {PEL_AT(0, 0), 0, star, hues, 5};
    assert_int_equal(pel_fan_init(&fan, &twice, memory), PEL_ERROR_RANGE);
    p.n = 3;
    p.hub.y = PEL_PX(-1);
    assert_int_equal(pel_fan_init(&fan, &p, memory), PEL_ERROR_RANGE);
    p.hub.y = PEL_COORDINATE_MAX + 1;
    assert_int_equal(pel_fan_init(&fan, &p, memory), PEL_ERROR_RANGE);
    p.n = 0;
    pel_fan_set_hub(&p);
    assert_int_equal(p.hub.x, PEL_PX(10));
}
