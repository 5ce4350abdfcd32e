/* What events do to a view: the same for a window, a touch screen and buttons.
 */
#include "tests/support/check.h"

#include <math.h>
#include <string.h>

#include "sim/view/viewer.h"

/* A view of 200 x 100 pixels; drags move it by half a turn across. */
static void make(struct viewer *viewer)
{
    const struct model_source source = {.path = MESH_BUILTIN};
    struct scene_settings settings = scene_default;
    struct model model;
    memset(viewer, 0, sizeof(*viewer));
    settings.camera.width = viewer->width = 200;
    settings.camera.height = viewer->height = 100;
    assert_true(model_load(&model, &source));
    assert_true(view_init(&viewer->view, &settings, &model));
    model_free(&model);
}

/* Each row goes on where the one before it ended. Spin is in turns / 400. */
static void test_events(void)
{
    static const struct {
        struct pel_input event;
        int spin;
        bool stale, save, over;
    } rows[] = {
        {{.kind = PEL_INPUT_MOVE, .x = 50}, 0, 0, 0, 0}, /* nothing is held */
        {{.kind = PEL_INPUT_BUTTON, .code = 3, .state = 1}, 0, 0, 0, 0},
        {{.kind = PEL_INPUT_MOVE, .x = 50}, 0, 0, 0, 0},
        {{.kind = PEL_INPUT_BUTTON, .code = 1, .state = 1}, 0, 0, 0, 0},
        {{.kind = PEL_INPUT_MOVE, .x = 50}, 50, 1, 0, 0},
        {{.kind = PEL_INPUT_LOST}, 50, 0, 0, 0},
        {{.kind = PEL_INPUT_MOVE, .x = 50}, 50, 0, 0, 0},
        {{.kind = PEL_INPUT_POINT, .x = 20}, 50, 0, 0, 0}, /* tablet */
        {{.kind = PEL_INPUT_BUTTON, .code = 1, .state = 1}, 50, 0, 0, 0},
        {{.kind = PEL_INPUT_POINT, .x = 30}, 60, 1, 0, 0},
        {{.kind = PEL_INPUT_BUTTON, .code = 1}, 60, 0, 0, 0},
        {{.kind = PEL_INPUT_POINT, .x = 80}, 60, 0, 0, 0},
        {{.kind = PEL_INPUT_TOUCH, .x = 10, .state = 1}, 60, 0, 0, 0},
        {{.kind = PEL_INPUT_TOUCH, .code = 1, .x = 150, .state = 1},
         60,
         0,
         0,
         0},
        {{.kind = PEL_INPUT_TOUCH, .x = 30, .state = 2}, 80, 1, 0, 0},
        {{.kind = PEL_INPUT_TOUCH, .x = 30}, 80, 0, 0, 0},
        {{.kind = PEL_INPUT_TOUCH, .x = 190, .state = 1}, 80, 0, 0, 0},
        {{.kind = PEL_INPUT_TOUCH, .x = 190}, 80, 0, 0, 0},
        {{.kind = PEL_INPUT_WHEEL, .y = 2}, 80, 1, 0, 0}, /* closer */
        {{.kind = PEL_INPUT_WHEEL, .x = 12}, 180, 1, 0, 0},
        {{.kind = PEL_INPUT_KEY, .code = PEL_KEY_LEFT, .state = 0},
         180,
         0,
         0,
         0},
        {{.kind = PEL_INPUT_DEVICE, .code = 3, .state = 1}, 180, 0, 0, 0},
        {{.kind = PEL_INPUT_KEY, .code = 'w', .state = 1}, 180, 0, 1, 0},
        {{.kind = PEL_INPUT_KEY, .code = 'q', .state = 1}, 180, 0, 0, 1},
    };
    struct viewer viewer;
    make(&viewer);
    for (size_t i = 0; i < sizeof(rows) / sizeof(rows[0]); i++) {
        viewer.stale = false;
        const bool save = viewer_input(&viewer, &rows[i].event);
        if (save != rows[i].save || viewer.stale != rows[i].stale ||
            viewer.over != rows[i].over ||
            fabs(viewer.view.spin * 400 - rows[i].spin) > 1e-6)
            fail_msg("row %d: spin %f, stale %d, save %d, over %d", (int)i,
                     viewer.view.spin * 400, viewer.stale, save, viewer.over);
    }
    assert_true(fabs(viewer.view.zoom - 1.125 * 1.125) < 1e-9);
}

int main(void)
{
    return RUN_TESTS(test_events);
}
