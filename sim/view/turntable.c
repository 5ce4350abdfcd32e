#include "sim/view/turntable.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/raster/rectangle.h"
#include "sim/cli/device.h"

static const double turns_per_ms = 1.0 / 10000;

enum { OWN_SIZE = 800 };

/* The camera is framed for the first size; others show what that does. */
static bool resize(struct show *show, int width, int height)
{
    struct turntable *t = (struct turntable *)show;
    const bool first = t->width == 0;
    t->width = width;
    t->height = height;
    if (!first)
        return true;
    struct scene_settings settings = *t->settings;
    settings.camera.width = width;
    settings.camera.height = height;
    const bool turning = t->view.turning;
    const bool done = view_init(&t->view, &settings, t->model);
    t->view.turning = turning;
    return done;
}

static bool advance(struct show *show, double time)
{
    struct turntable *t = (struct turntable *)show;
    if (!t->view.turning)
        return false;
    view_orbit(&t->view, t->has_step ? t->step : time * turns_per_ms, 0);
    return true;
}

static bool draw_band(struct canvas *band, const void *context)
{
    const struct turntable *t = context;
    pel_clear(&band->surface, t->view.settings.camera.background);
    return scene_draw(&t->scene, &band->surface);
}

static bool draw(struct show *show, const struct pel_surface *surface)
{
    struct turntable *t = (struct turntable *)show;
    const struct pel_rect *clip = &surface->clip;
    struct scene_settings settings;
    view_settings(&t->view, clip->x1 - clip->x0, clip->y1 - clip->y0,
                  &settings);
    settings.left = clip->x0;
    settings.top = clip->y0;
    if (!scene_prepare(&t->scene, &settings))
        return false;
    t->view.lit = t->scene.core.shading != &pel_shade_flat &&
                  t->scene.core.shading != &pel_shade_gouraud;
    struct canvas canvas = {.surface = *surface};
    return device_draw_bands(&t->pool, &canvas, draw_band, t);
}

static void title(const struct show *show, char *text)
{
    const struct turntable *t = (const struct turntable *)show;
    static const char *const shades[] = {"flat", "Gouraud", "Phong"};
    static const char *const textures[] = {"no texture", "nearest", "bilinear"};
    static const char *const orders[] = {
        "right order", "painter", "z-buffer 16", "z-buffer 32", "z-buffer 32"};
    const struct scene_settings *s = &t->view.settings;
    const bool has_texture = t->model->textures > 0;
    char steps[32] = "";
    if (s->tolerance > 0 && s->shade == SCENE_PHONG)
        snprintf(steps, sizeof steps, " to %g steps", s->tolerance);
    snprintf(text, SHOW_TITLE_SIZE, "%u triangles, %s%s, %s, %s, %s",
             (unsigned)t->model->mesh.triangles, shades[s->shade], steps,
             t->view.lit ? "lit" : "no light",
             textures[has_texture ? s->texture : SCENE_TEXTURE_NONE],
             orders[s->order]);
}

/* Half a turn from one side of the picture to the other. */
static void drag(struct turntable *t, int x, int y)
{
    if (!t->dragging || t->width <= 0)
        return;
    view_orbit(&t->view, x * 0.5 / t->width, y * 0.5 / t->height);
}

static void drag_to(struct turntable *t, const struct pel_input *e)
{
    drag(t, e->x - t->x, e->y - t->y);
    t->x = e->x;
    t->y = e->y;
}

static void touch(struct turntable *t, const struct pel_input *e)
{
    if (e->code != 0)
        return;
    t->dragging = t->dragging && e->state == PEL_INPUT_AGAIN;
    drag_to(t, e);
    t->dragging = e->state != PEL_INPUT_UP;
}

/* One press, one notch of the wheel turns by ARROW turns or comes closer by the
 * factor CLOSER. */
#define ARROW (1.0 / 48)
#define CLOSER 1.125

static enum view_action light(struct view *view, int key)
{
    static const char terms[] = "ads";
    struct scene_settings *s = &view->settings;
    const char *term = key > 0 && key < 128 ? strchr(terms, key) : NULL;
    const int lights = s->lights > 0 ? s->lights : 1;
    const bool number = key >= '1' && key <= '9' && key - '0' <= lights;
    if (key == 'l' && s->shade == SCENE_PHONG)
        return VIEW_NOTHING;
    if (key != 'l' && !term && !number)
        return VIEW_NOTHING;
    if (key == 'l' || !view->lit) {
        s->lit = view->lit ? SCENE_UNLIT : SCENE_LIT;
        view->lit = !view->lit;
    } else if (term)
        s->terms ^= 1u << (term - terms);
    else
        view->dark ^= 1u << (key - '1');
    return VIEW_CHANGED;
}

static enum view_action press(struct view *view, int key)
{
    struct scene_settings *s = &view->settings;
    switch (key) {
    case 'q':
    case PEL_KEY_ESCAPE:
        return VIEW_END;
    case 'w':
        return VIEW_SAVE;
    case ' ':
    case PEL_KEY_ENTER:
        view->turning = !view->turning;
        break;
    case 'f':
    case 'g':
    case 'p':
        s->shade = key == 'f'   ? SCENE_FLAT
                   : key == 'g' ? SCENE_GOURAUD
                                : SCENE_PHONG;
        if (key == 'p' && s->lit == SCENE_UNLIT)
            s->lit = SCENE_LIT_AUTO;
        break;
    case 't':
        s->texture = (enum scene_texture)((s->texture + 1) % 3);
        break;
    case 'z':
        s->order = s->order != SCENE_PAINTER            ? SCENE_PAINTER
                   : view->first.order != SCENE_PAINTER ? view->first.order
                                                        : SCENE_AUTO;
        break;
    case 'e':
        s->tolerance = s->tolerance > 4   ? 0
                       : s->tolerance < 1 ? 1
                                          : s->tolerance * 2;
        break;
    case 'm':
        s->show_methods = !s->show_methods;
        break;
    case 'r':
        view_reset(view);
        break;
    default:
        return light(view, key);
    }
    return VIEW_CHANGED;
}

enum view_action view_key(struct view *view, int key)
{
    static const struct {
        int key;
        double right, up, closer;
    } moves[] = {
        {PEL_KEY_LEFT, -ARROW, 0, 1}, {PEL_KEY_RIGHT, ARROW, 0, 1},
        {PEL_KEY_UP, 0, -ARROW, 1},   {PEL_KEY_DOWN, 0, ARROW, 1},
        {'+', 0, 0, CLOSER},          {'=', 0, 0, CLOSER}, /* + without shift */
        {'-', 0, 0, 1 / CLOSER},
    };
    for (size_t i = 0; i < sizeof(moves) / sizeof(moves[0]); i++)
        if (moves[i].key == key) {
            view_orbit(view, moves[i].right, moves[i].up);
            view_zoom(view, moves[i].closer);
            return VIEW_CHANGED;
        }
    return press(view, key);
}

static enum view_action input(struct show *show, const struct pel_input *e)
{
    struct turntable *t = (struct turntable *)show;
    switch (e->kind) {
    case PEL_INPUT_LOST:
        t->dragging = false;
        return VIEW_NOTHING;
    case PEL_INPUT_KEY:
        return e->state == PEL_INPUT_UP ? VIEW_NOTHING
                                        : view_key(&t->view, e->code);
    case PEL_INPUT_BUTTON:
        if (e->code == 1)
            t->dragging = e->state != PEL_INPUT_UP;
        return VIEW_NOTHING;
    case PEL_INPUT_MOVE:
        drag(t, e->x, e->y);
        break;
    case PEL_INPUT_POINT:
        drag_to(t, e);
        break;
    case PEL_INPUT_TOUCH:
        touch(t, e);
        break;
    case PEL_INPUT_WHEEL:
        view_zoom(&t->view, pow(CLOSER, e->y));
        view_orbit(&t->view, e->x * ARROW, 0);
        return VIEW_CHANGED;
    default:
        return VIEW_NOTHING;
    }
    return t->dragging ? VIEW_CHANGED : VIEW_NOTHING;
}

bool turntable_init(struct turntable *t, const struct model *model,
                    const struct scene_settings *settings, int jobs)
{
    *t = (struct turntable){
        .show = {.resize = resize,
                 .input = input,
                 .advance = advance,
                 .draw = draw,
                 .title = title,
                 .keys = VIEW_KEYS_HELP,
                 .width = OWN_SIZE,
                 .height = OWN_SIZE},
        .model = model,
        .settings = settings,
    };
    t->view.turning = true;
    pel_pool_start(&t->pool, jobs > 0 ? jobs : pel_pool_processors());
    return scene_init(&t->scene, model);
}

void turntable_free(struct turntable *t)
{
    pel_pool_end(&t->pool);
    scene_free(&t->scene);
}
