#include "sim/view/keys.h"

#include <string.h>

/* Of one press: turns, and a factor. */
#define ARROW (1.0 / 48)
#define CLOSER 1.125

static enum view_action move(struct view *view, int key)
{
    switch (key) {
    case VIEW_KEY_LEFT:
        view_orbit(view, -ARROW, 0);
        break;
    case VIEW_KEY_RIGHT:
        view_orbit(view, ARROW, 0);
        break;
    case VIEW_KEY_UP:
        view_orbit(view, 0, -ARROW);
        break;
    case VIEW_KEY_DOWN:
        view_orbit(view, 0, ARROW);
        break;
    case '+':
    case '=': /* the same key without shift */
        view_zoom(view, CLOSER);
        break;
    case '-':
        view_zoom(view, 1 / CLOSER);
        break;
    case ' ':
        view->turning = !view->turning;
        break;
    default:
        return VIEW_NOTHING;
    }
    return VIEW_CHANGED;
}

static void shade(struct scene_settings *s, enum scene_shade shade)
{
    s->shade = shade;
    if (shade == SCENE_PHONG && s->lit == SCENE_UNLIT)
        s->lit = SCENE_LIT_AUTO;
}

static enum view_action look(struct view *view, int key)
{
    struct scene_settings *s = &view->settings;
    switch (key) {
    case 'f':
        shade(s, SCENE_FLAT);
        break;
    case 'g':
        shade(s, SCENE_GOURAUD);
        break;
    case 'p':
        shade(s, SCENE_PHONG);
        break;
    case 't':
        s->texture = (enum scene_texture)((s->texture + 1) % 3);
        break;
    case 'z':
        s->order = s->order != SCENE_PAINTER            ? SCENE_PAINTER
                   : view->first.order != SCENE_PAINTER ? view->first.order
                                                        : SCENE_ZBUFFER32;
        break;
    case 'r':
        view_reset(view);
        break;
    default:
        return VIEW_NOTHING;
    }
    return VIEW_CHANGED;
}

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

enum view_action view_key(struct view *view, int key)
{
    if (key == 'q' || key == VIEW_KEY_ESCAPE)
        return VIEW_END;
    if (key == 'w')
        return VIEW_SAVE;
    enum view_action action = move(view, key);
    if (action == VIEW_NOTHING)
        action = look(view, key);
    return action == VIEW_NOTHING ? light(view, key) : action;
}

int view_terminal_key(const char *bytes, size_t count, size_t *used)
{
    static const int arrows[4] = {VIEW_KEY_UP, VIEW_KEY_DOWN, VIEW_KEY_RIGHT,
                                  VIEW_KEY_LEFT};
    *used = 1;
    if (bytes[0] != VIEW_KEY_ESCAPE || count < 2 ||
        (bytes[1] != '[' && bytes[1] != 'O'))
        return (unsigned char)bytes[0];
    *used = 2;
    /* Parameters and intermediate bytes, then a final one. */
    while (*used < count && bytes[*used] >= 0x20 && bytes[*used] < 0x40)
        ++*used;
    const char end = *used < count ? bytes[(*used)++] : '\0';
    return *used == 3 && end >= 'A' && end <= 'D' ? arrows[end - 'A']
                                                  : VIEW_KEY_UNKNOWN;
}
