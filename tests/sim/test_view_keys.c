/* What keys, mouse and window sizes do to a view; which keys a terminal's bytes
 * are. */
#include "tests/support/check.h"

#include <math.h>
#include <string.h>

#include "sim/view/turntable.h"
#include "sim/view/viewer.h"

/* A view of the built-in mesh. */
static void make(struct view *view, struct model *model)
{
    const struct model_source source = {.path = MESH_BUILTIN};
    struct scene_settings settings = scene_default;
    settings.camera.width = 200;
    settings.camera.height = 100;
    assert_true(model_load(model, &source));
    assert_true(view_init(view, &settings, model));
}

/* The same for a test that needs no model. */
static struct view *new_view(void)
{
    static struct view view;
    struct model model;
    make(&view, &model);
    model_free(&model);
    return &view;
}

static void press(struct view *view, const char *keys)
{
    for (; *keys; keys++)
        assert_int_equal(view_key(view, *keys), VIEW_CHANGED);
}

TEST(shade)
{
    struct view *view = new_view();
    press(view, "f");
    assert_int_equal(view->settings.shade, SCENE_FLAT);
    press(view, "p");
    assert_int_equal(view->settings.shade, SCENE_PHONG);
    press(view, "g");
    assert_int_equal(view->settings.shade, SCENE_GOURAUD);
}

TEST(tolerance)
{
    struct view *view = new_view();
    const double steps[] = {1, 2, 4, 8, 0};
    for (int i = 0; i < 5; i++) {
        press(view, "e");
        assert_true(view->settings.tolerance == steps[i]);
    }
    press(view, "m");
    assert_true(view->settings.show_methods);
    press(view, "m");
    assert_false(view->settings.show_methods);
}

TEST(texture_and_order)
{
    struct view *view = new_view();
    const int textures[] = {SCENE_TEXTURE_NONE, SCENE_TEXTURE_NEAREST,
                            SCENE_TEXTURE_BILINEAR};
    for (int i = 0; i < 3; i++) {
        press(view, "t");
        assert_int_equal(view->settings.texture, textures[i]);
    }
    press(view, "z");
    assert_int_equal(view->settings.order, SCENE_PAINTER);
    press(view, "z");
    assert_int_equal(view->settings.order, SCENE_AUTO);
    view->first.order = view->settings.order = SCENE_ZBUFFER16;
    press(view, "zz");
    assert_int_equal(view->settings.order, SCENE_ZBUFFER16);
}

TEST(terms)
{
    struct view *view = new_view();
    view->lit = true;
    press(view, "a");
    assert_int_equal(view->settings.terms, SCENE_DIFFUSE | SCENE_SPECULAR);
    press(view, "ds");
    assert_int_equal(view->settings.terms, 0);
    press(view, "sda");
    assert_int_equal(view->settings.terms, SCENE_ALL_TERMS);
}

/* The first key of light brings the light and takes nothing from it. */
TEST(unlit)
{
    const char keys[] = "1adsl";
    struct view *view = new_view();
    for (int i = 0; keys[i]; i++) {
        view->lit = false;
        view->settings.lit = SCENE_LIT_AUTO;
        assert_int_equal(view_key(view, keys[i]), VIEW_CHANGED);
        assert_int_equal(view->settings.lit, SCENE_LIT);
        assert_true(view->lit);
        assert_int_equal(view->dark, 0);
        assert_int_equal(view->settings.terms, SCENE_ALL_TERMS);
    }
    press(view, "l");
    assert_int_equal(view->settings.lit, SCENE_UNLIT);
    press(view, "p"); /* which is light */
    assert_int_equal(view->settings.lit, SCENE_LIT_AUTO);
    view->lit = true;
    assert_int_equal(view_key(view, 'l'), VIEW_NOTHING);
}

TEST(lights)
{
    struct view *view = new_view();
    struct scene_settings s;
    view->lit = true;
    view->first.lights = 3;
    for (int i = 0; i < 3; i++)
        view->first.light[i] = (struct scene_light){.color = {1, 2, 3}};
    view_reset(view);
    press(view, "13");
    view_settings(view, 200, 100, &s);
    assert_int_equal(s.lights, 3);
    assert_true(s.light[0].color[0] == 0 && s.light[0].color[2] == 0);
    assert_true(s.light[1].color[0] == 1 && s.light[1].color[2] == 3);
    assert_true(s.light[2].color[1] == 0);
    press(view, "1");
    view_settings(view, 200, 100, &s);
    assert_true(s.light[0].color[2] == 3);
    assert_int_equal(view_key(view, '4'), VIEW_NOTHING);
    assert_int_equal(view_key(view, '9'), VIEW_NOTHING);
    assert_int_equal(view_key(view, '0'), VIEW_NOTHING);
}

/* The light of those who name none can be switched off, too. */
TEST(own_light)
{
    struct view *view = new_view();
    struct scene_settings s;
    view->lit = true;
    view_settings(view, 200, 100, &s);
    assert_int_equal(s.lights, 0);
    press(view, "1");
    view_settings(view, 200, 100, &s);
    assert_int_equal(s.lights, 1);
    assert_true(s.light[0].color[0] == 0);
    assert_int_equal(view_key(view, '2'), VIEW_NOTHING);
}

TEST(turn)
{
    struct view *view = new_view();
    struct scene_settings s;
    assert_int_equal(view_key(view, PEL_KEY_RIGHT), VIEW_CHANGED);
    assert_true(view->spin > 0 && view->spin < 0.1);
    assert_int_equal(view_key(view, PEL_KEY_LEFT), VIEW_CHANGED);
    assert_int_equal(view_key(view, PEL_KEY_LEFT), VIEW_CHANGED);
    assert_true(view->spin > 0.9 && view->spin < 1);
    view->spin = 0.25;
    view->settings.turn[1] = 60000;
    view_settings(view, 200, 100, &s);
    assert_int_equal(s.turn[1], (60000 + 16384) % 65536);
    press(view, " ");
    assert_true(view->turning);
    press(view, " ");
    assert_false(view->turning);
}

static double height_of_eye(const struct view *view, double *distance)
{
    struct scene_settings s;
    double square = 0;
    view_settings(view, 200, 100, &s);
    for (int k = 0; k < 3; k++)
        square += pow(s.camera.eye[k] - s.camera.target[k], 2);
    *distance = sqrt(square);
    return s.camera.eye[1] - s.camera.target[1];
}

/* Up and down keep the distance and stop before the zenith and the nadir; what
 * was stopped comes back with the first key. */
TEST(tilt)
{
    struct view *view = new_view();
    double distance, now;
    const double start = height_of_eye(view, &distance);
    for (int i = 0; i < 40; i++)
        view_key(view, PEL_KEY_DOWN);
    const double top = height_of_eye(view, &now);
    assert_true(fabs(now - distance) < 1e-9 * distance);
    assert_true(top > start && top < distance && top > 0.99 * distance);
    view_key(view, PEL_KEY_UP);
    assert_true(height_of_eye(view, &now) < top);
    for (int i = 0; i < 40; i++)
        view_key(view, PEL_KEY_UP);
    assert_true(height_of_eye(view, &now) < -0.99 * distance);
}

TEST(zoom)
{
    struct view *view = new_view();
    double distance, now;
    height_of_eye(view, &distance);
    press(view, "+");
    height_of_eye(view, &now);
    assert_true(now < distance);
    press(view, "--");
    height_of_eye(view, &now);
    assert_true(now > distance);
    for (int i = 0; i < 100; i++)
        press(view, "=");
    height_of_eye(view, &now);
    assert_true(fabs(now - distance / 8) < 1e-9 * distance);
}

/* Another shape of window shows what the first did, and more. */
TEST(sizes)
{
    struct view *view = new_view();
    const struct camera *first = &view->first.camera;
    struct scene_settings s;
    view_settings(view, 400, 100, &s);
    assert_int_equal(s.camera.width, 400);
    assert_true(s.camera.sensor[0] == 2 * first->sensor[0]);
    assert_true(s.camera.sensor[1] == first->sensor[1]);
    view_settings(view, 100, 100, &s);
    assert_true(s.camera.sensor[0] == first->sensor[0]);
    assert_true(s.camera.sensor[1] == 2 * first->sensor[1]);
}

/* What nobody touched is what `pel render` draws. */
TEST(first)
{
    struct view *view = new_view();
    struct scene_settings s;
    press(view, "+- tzf");
    view_key(view, PEL_KEY_UP);
    view_key(view, PEL_KEY_RIGHT);
    press(view, "r");
    view_settings(view, 200, 100, &s);
    assert_memory_equal(s.camera.eye, view->first.camera.eye,
                        sizeof(s.camera.eye));
    assert_memory_equal(s.camera.sensor, view->first.camera.sensor,
                        sizeof(s.camera.sensor));
    assert_int_equal(s.camera.has_sensor, view->first.camera.has_sensor);
    assert_int_equal(s.turn[1], 0);
    assert_int_equal(s.shade, SCENE_GOURAUD);
    assert_int_equal(s.texture, SCENE_TEXTURE_BILINEAR);
    assert_int_equal(s.order, SCENE_AUTO);
    assert_true(view->turning);
}

TEST(others)
{
    struct view *view = new_view();
    struct view before;
    memcpy(&before, view, sizeof(before));
    assert_int_equal(view_key(view, 'w'), VIEW_SAVE);
    assert_int_equal(view_key(view, 'q'), VIEW_END);
    assert_int_equal(view_key(view, PEL_KEY_ESCAPE), VIEW_END);
    for (int key = -1; key < 400; key++)
        if (key < 0 || key > 127 ||
            !strchr("fgptzemr+=- \r123456789adslwq\033", key))
            if (key < PEL_KEY_LEFT || key > PEL_KEY_DOWN)
                assert_int_equal(view_key(view, key), VIEW_NOTHING);
    assert_memory_equal(&before, view, sizeof(before));
}

/* The farthest that keys lead to can be drawn. */
TEST(extremes)
{
    static const int tilts[] = {PEL_KEY_UP, PEL_KEY_DOWN};
    struct view *view = new_view();
    struct scene_settings s;
    struct model model;
    struct scene scene;
    make(view, &model);
    assert_true(scene_init(&scene, &model));
    for (int i = 0; i < 8; i++) {
        view_reset(view);
        view->first.camera.projection =
            i & 4 ? PEL_ORTHOGRAPHIC : PEL_PERSPECTIVE;
        for (int k = 0; k < 40; k++) {
            press(view, i & 1 ? "+" : "-");
            view_key(view, tilts[i >> 1 & 1]);
        }
        view_settings(view, i & 1 ? 3000 : 200, 20, &s);
        assert_true(scene_prepare(&scene, &s));
    }
    scene_free(&scene);
    model_free(&model);
}

TEST(terminal)
{
    static const char bytes[] = "q\033[A\033OB\033[1;5C\033[C\033[D\033[3~"
                                "\033[[B\033OR\033OZ\033[[Z\033";
    static const int keys[] = {'q',           PEL_KEY_UP,     PEL_KEY_DOWN,
                               PEL_KEY_OTHER, PEL_KEY_RIGHT,  PEL_KEY_LEFT,
                               PEL_KEY_OTHER, PEL_KEY_F1 + 1, PEL_KEY_F1 + 2,
                               PEL_KEY_OTHER, PEL_KEY_OTHER,  PEL_KEY_ESCAPE};
    size_t at = 0, used = 0;
    for (size_t i = 0; i < sizeof(keys) / sizeof(keys[0]); i++) {
        assert_true(at < sizeof(bytes) - 1);
        assert_int_equal(
            view_terminal_key(bytes + at, sizeof(bytes) - 1 - at, &used),
            keys[i]);
        at += used;
    }
    assert_int_equal(at, sizeof(bytes) - 1);
    assert_int_equal(view_terminal_key("\033[", 2, &used), PEL_KEY_OTHER);
    assert_int_equal(used, 2);
    assert_int_equal(view_terminal_key("\344", 1, &used), 0344);
}
