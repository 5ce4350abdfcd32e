/* What a tolerance leaves out of a whole frame or part changes no more than is
 * taken from the tolerance, and hardly less. */
#include "core/scene/select.h"
#include "tests/support/any_scene.h"
#include "tests/support/check.h"

enum { SIDE = 96 };

static struct any_scene s;

/* Draws the scene, and then with another shading and mapping; adds to `tight`
 * what the largest difference is of what was taken. */
static void check(const struct pel_shading *shading,
                  const struct pel_shading *fewer,
                  const struct pel_mapping *mapping, double *tight)
{
    static struct canvas exact, chosen;
    struct pel_frame frame;
    any_scene_draw(&s, shading, &frame, &exact);
    s.texture.mapping = mapping;
    any_scene_draw(&s, fewer, &frame, &chosen);
    const int32_t used = s.scene.tolerance - frame.room;
    const int32_t off = canvas_difference(&exact, &chosen);
    if (used < 0 || used > s.scene.tolerance || off * 256 >= used + 256)
        fail_msg("off by %d for %d / 256; %s", off, used, cases_replay());
    if (used >= 4 * 256 && off * 256. / used > *tight)
        *tight = off * 256. / used;
}

static void expect_tight(const char *what, double tight)
{
    print_message("%s: worst difference by what was taken: %.2f\n", what,
                  tight);
    assert_true(tight > 0.5 || cases_alone() || cases_scaled(100) < 100);
}

TEST(lights)
{
    const struct pel_shading fewer = {pel_frame_start_chosen, NULL,
                                      pel_shade_phong.paint};
    double tight = 0;
    for (struct cases c = cases_of(400); cases_next(&c);) {
        any_scene(&c.random, &s, SIDE);
        any_scene_light(&c.random, &s);
        s.lighting.ambient = 0;
        for (int i = 0; i < 3 * ANY_LIGHTS; i++)
            s.light[i / 3].color[i % 3] = random_between(&c.random, 0, 9999);
        s.scene.tolerance = random_between(&c.random, 0, 255 * 256);
        check(&pel_shade_phong, &fewer, NULL, &tight);
    }
    expect_tight("lights", tight);
}

TEST(nearest_texels)
{
    static const struct pel_shading *const shadings[] = {
        &pel_shade_flat, &pel_shade_gouraud, &pel_shade_lit_flat,
        &pel_shade_lit_gouraud, &pel_shade_phong};
    double tight = 0;
    for (struct cases c = cases_of(400); cases_next(&c);) {
        const uint32_t i = random_word(&c.random) % 5;
        any_scene(&c.random, &s, SIDE);
        any_scene_light(&c.random, &s);
        any_scene_noise(&c.random, &s, random_between(&c.random, 2, 5));
        any_scene_smooth(&c.random, &s);
        s.lighting.diffuse = random_between(&c.random, 0, 4 * 65536);
        s.lighting.ambient = random_between(&c.random, 0, 4 * 65536);
        s.scene.tolerance = random_between(&c.random, 0, 32 * 256);
        check(shadings[i], shadings[i], &pel_map_chosen, &tight);
    }
    expect_tight("nearest texels", tight);
}
