/* Lights that a tolerance leaves out of a frame change no more than is taken
 * from the tolerance, and hardly less. */
#include "core/scene/select.h"
#include "tests/support/any_scene.h"
#include "tests/support/check.h"

enum { SIDE = 96 };

static struct any_scene s;

TEST(lights)
{
    static struct canvas exact, chosen;
    const struct pel_shading fewer = {pel_frame_start_chosen, NULL,
                                      pel_shade_phong.paint, 0};
    struct pel_frame frame;
    double tight = 0;
    for (struct cases c = cases_of(400); cases_next(&c);) {
        any_scene(&c.random, &s, SIDE);
        any_scene_light(&c.random, &s);
        s.lighting.ambient = 0;
        for (int i = 0; i < 3 * ANY_LIGHTS; i++)
            s.light[i / 3].color[i % 3] = random_between(&c.random, 0, 9999);
        s.scene.tolerance = random_between(&c.random, 0, 255 * 256);
        any_scene_draw(&s, &pel_shade_phong, &frame, &exact);
        any_scene_draw(&s, &fewer, &frame, &chosen);
        const int32_t used = s.scene.tolerance - frame.tolerance;
        const int32_t off = canvas_difference(&exact, &chosen);
        if (used < 0 || used > s.scene.tolerance || off * 256 >= used + 256)
            fail_msg("off by %d for %d / 256; %s", off, used, cases_replay());
        if (used >= 4 * 256 && off * 256. / used > tight)
            tight = off * 256. / used;
    }
    print_message("worst difference by what was taken: %.2f\n", tight);
    assert_true(tight > 0.5 || cases_alone() || cases_scaled(100) < 100);
}
