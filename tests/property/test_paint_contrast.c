/* The bound of nearest against bilinear texels: the largest difference there
 * is, no more and no less. */
#include "core/paint/texture_contrast.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"

enum { SIDE = 7, PLACES = 2 * SIDE };

static pel_color texel[SIDE * SIDE];

/* Along some places half a texel apart, in the middles and on the borders of
 * texels, or a little before. */
static int32_t difference(const struct pel_texels *texels, int wrap,
                          const struct pel_texture_map *map)
{
    struct pel_texture near, mix;
    pel_color a[PLACES], b[PLACES];
    int32_t most = 0;
    assert_int_equal(pel_texture_init_nearest(&near, texels, map), PEL_OK);
    assert_int_equal(pel_texture_init_bilinear(&mix, texels, map), PEL_OK);
    near.wrap_u = near.wrap_v = mix.wrap_u = mix.wrap_v = (uint8_t)wrap;
    for (int32_t y = 0; y < PLACES; y++) {
        near.base.colors(&near.base, 0, y, PLACES, a);
        mix.base.colors(&mix.base, 0, y, PLACES, b);
        for (int i = 0; i < PLACES * 4; i++)
            most = pel_max(
                most, pel_magnitude((int32_t)(a[i / 4] >> i % 4 * 8 & 255) -
                                    (int32_t)(b[i / 4] >> i % 4 * 8 & 255)));
    }
    return most;
}

static int32_t largest(const struct pel_texels *texels, int wrap)
{
    static const uint64_t before[2] = {0, UINT64_C(1) << 22};
    const uint64_t half = UINT64_C(1) << 31;
    int32_t most = 0;
    for (int i = 0; i < 4; i++) {
        const struct pel_texture_map map = {{0 - before[i & 1], half, 0},
                                            {0 - before[i >> 1], 0, half}};
        most = pel_max(most, difference(texels, wrap, &map));
    }
    return most;
}

TEST(contrast_is_the_largest_difference)
{
    for (struct cases c = cases_of(2000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_texels texels = {NULL, texel,
                                          random_between(r, 1, SIDE),
                                          random_between(r, 1, SIDE), false};
        const pel_color own = random_word(r);
        const pel_color noise =
            random_word(r) & UINT32_C(0xFFFFFF) >> random_between(r, 0, 31);
        for (int i = 0; i < SIDE * SIDE; i++)
            texel[i] = own ^ (random_word(r) & noise);
        const int32_t bound = pel_texels_contrast(&texels) - 1;
        assert_int_equal(bound, largest(&texels, PEL_WRAP_REPEAT));
        assert_true(largest(&texels, PEL_WRAP_CLAMP) <= bound);
        assert_true(largest(&texels, PEL_WRAP_MIRROR) <= bound);
    }
}

TEST(no_bound)
{
    const struct pel_texels texels = {NULL, texel, SIDE, SIDE, false};
    const struct pel_texels none = {NULL, NULL, SIDE, SIDE, false};
    for (int i = 0; i < SIDE * SIDE; i++)
        texel[i] = UINT32_C(0x7F102030);
    assert_int_equal(pel_texels_contrast(&texels), 1);
    texel[SIDE * SIDE - 1] = UINT32_C(0x80102030);
    assert_int_equal(pel_texels_contrast(&texels), 0);
    assert_int_equal(pel_texels_contrast(&none), 0);
    assert_int_equal(pel_texels_contrast(NULL), 0);
}
