/* What events do to a mesh: the same from a window, a touch screen and buttons.
 */
#include "tests/support/check.h"

#include <math.h>
#include <string.h>

#include "sim/view/turntable.h"

/* Each row goes on where the one before it ended. Spin is in turns / 400. */
TEST(events)
{
    static const struct {
        struct pel_input event;
        int spin, action;
    } rows[] = {
        {{.kind = PEL_INPUT_MOVE, .x = 50}, 0, VIEW_NOTHING}, /* free */
        {{.kind = PEL_INPUT_BUTTON, .code = 3, .state = 1}, 0, VIEW_NOTHING},
        {{.kind = PEL_INPUT_MOVE, .x = 50}, 0, VIEW_NOTHING},
        {{.kind = PEL_INPUT_BUTTON, .code = 1, .state = 1}, 0, VIEW_NOTHING},
        {{.kind = PEL_INPUT_MOVE, .x = 50}, 50, VIEW_CHANGED},
        {{.kind = PEL_INPUT_LOST}, 50, VIEW_NOTHING},
        {{.kind = PEL_INPUT_MOVE, .x = 50}, 50, VIEW_NOTHING},
        {{.kind = PEL_INPUT_POINT, .x = 20}, 50, VIEW_NOTHING}, /* tablet */
        {{.kind = PEL_INPUT_BUTTON, .code = 1, .state = 1}, 50, VIEW_NOTHING},
        {{.kind = PEL_INPUT_POINT, .x = 30}, 60, VIEW_CHANGED},
        {{.kind = PEL_INPUT_BUTTON, .code = 1}, 60, VIEW_NOTHING},
        {{.kind = PEL_INPUT_POINT, .x = 80}, 60, VIEW_NOTHING},
        {{.kind = PEL_INPUT_TOUCH, .x = 10, .state = 1}, 60, VIEW_CHANGED},
        {{.kind = PEL_INPUT_TOUCH, .code = 1, .x = 9}, 60, VIEW_CHANGED},
        {{.kind = PEL_INPUT_TOUCH, .x = 30, .state = 2}, 80, VIEW_CHANGED},
        {{.kind = PEL_INPUT_TOUCH, .x = 30}, 80, VIEW_NOTHING},
        {{.kind = PEL_INPUT_TOUCH, .x = 190, .state = 1}, 80, VIEW_CHANGED},
        {{.kind = PEL_INPUT_TOUCH, .x = 190}, 80, VIEW_NOTHING},
        {{.kind = PEL_INPUT_WHEEL, .y = 2}, 80, VIEW_CHANGED}, /* closer */
        {{.kind = PEL_INPUT_WHEEL, .x = 12}, 180, VIEW_CHANGED},
        {{.kind = PEL_INPUT_KEY, .code = 'q'}, 180, VIEW_NOTHING},
        {{.kind = PEL_INPUT_DEVICE, .code = 3, .state = 1}, 180, VIEW_NOTHING},
        {{.kind = PEL_INPUT_KEY, .code = 'w', .state = 1}, 180, VIEW_SAVE},
        {{.kind = PEL_INPUT_KEY, .code = 'q', .state = 1}, 180, VIEW_END},
    };
    const struct model_source source = {.path = MESH_BUILTIN};
    struct scene_settings settings = scene_default;
    struct turntable t;
    struct model model;
    assert_true(model_load(&model, &source));
    assert_true(turntable_init(&t, &model, &settings, 1));
    assert_true(t.show.resize(&t.show, 200, 100));
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        const int action = t.show.input(&t.show, &rows[i].event);
        if (action != rows[i].action ||
            fabs(t.view.spin * 400 - rows[i].spin) > 1e-6)
            fail_msg("row %d: spin %f, action %d", (int)i, t.view.spin * 400,
                     action);
    }
    assert_true(fabs(t.view.zoom - 1.125 * 1.125) < 1e-9);
    turntable_free(&t);
    model_free(&model);
}
