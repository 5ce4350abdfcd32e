#include "sim/view/keys.h"

#include <string.h>

/* One press turns by ARROW turns or comes closer by the factor CLOSER. */
#define ARROW (1.0 / 48)
#define CLOSER 1.125

/* Keys that turn the model right and up, and come closer. `=' is the key of `+'
 * without shift. */
static enum view_action move(struct view *view, int key)
{
    static const struct {
        int key;
        double right, up, closer;
    } moves[] = {
        {PEL_KEY_LEFT, -ARROW, 0, 1}, {PEL_KEY_RIGHT, ARROW, 0, 1},
        {PEL_KEY_UP, 0, -ARROW, 1},   {PEL_KEY_DOWN, 0, ARROW, 1},
        {'+', 0, 0, CLOSER},          {'=', 0, 0, CLOSER},
        {'-', 0, 0, 1 / CLOSER},
    };
    if (key == ' ' || key == PEL_KEY_ENTER) {
        view->turning = !view->turning;
        return VIEW_CHANGED;
    }
    for (size_t i = 0; i < sizeof(moves) / sizeof(moves[0]); i++)
        if (moves[i].key == key) {
            view_orbit(view, moves[i].right, moves[i].up);
            view_zoom(view, moves[i].closer);
            return VIEW_CHANGED;
        }
    return VIEW_NOTHING;
}

static enum view_action change_appearance(struct view *view, int key)
{
    struct scene_settings *s = &view->settings;
    switch (key) {
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
    if (key == 'q' || key == PEL_KEY_ESCAPE)
        return VIEW_END;
    if (key == 'w')
        return VIEW_SAVE;
    enum view_action action = move(view, key);
    if (action == VIEW_NOTHING)
        action = change_appearance(view, key);
    return action == VIEW_NOTHING ? light(view, key) : action;
}

/* Of a sequence that has `used` bytes and ends so: arrows; F1 to F4 or F5,
 * which begin with SS3, or with CSI [ on a virtual terminal. */
static int sequence_key(size_t used, bool ss3, char end)
{
    static const int arrows[4] = {PEL_KEY_UP, PEL_KEY_DOWN, PEL_KEY_RIGHT,
                                  PEL_KEY_LEFT};
    if (used == 3 && end >= 'A' && end <= 'D')
        return arrows[end - 'A'];
    if (used == 3 && ss3 && end >= 'P' && end <= 'S')
        return PEL_KEY_F1 + end - 'P';
    return used == 4 && !ss3 && end >= 'A' && end <= 'E'
               ? PEL_KEY_F1 + end - 'A'
               : PEL_KEY_OTHER;
}

int view_terminal_key(const char *bytes, size_t count, size_t *used)
{
    *used = 1;
    if (bytes[0] != PEL_KEY_ESCAPE || count < 2 ||
        (bytes[1] != '[' && bytes[1] != 'O'))
        return bytes[0] == '\n' ? PEL_KEY_ENTER : (unsigned char)bytes[0];
    *used = 2;
    /* Parameters and intermediate bytes, then a final one. */
    while (*used < count && bytes[*used] >= 0x20 && bytes[*used] < 0x40)
        ++*used;
    char end = *used < count ? bytes[(*used)++] : '\0';
    if (*used == 3 && end == '[' && *used < count)
        end = bytes[(*used)++];
    return sequence_key(*used, bytes[1] == 'O', end);
}
