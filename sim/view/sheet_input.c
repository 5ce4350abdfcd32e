/* What keys, pointers and fingers do to a sheet. */
#include "sim/script/commands.h"
#include "sim/view/sheet.h"

enum { ZOOM_MOST = 32 };

/* Marks one shape alone; -1: none. */
static void mark(struct sheet *s, int shape)
{
    s->picked = shape;
    for (int i = 0; i < s->shapes; i++)
        s->style[i].marked = i == shape;
}

static enum view_action pick(struct sheet *s)
{
    int x, y;
    const long item = sheet_compose(s) && sheet_pixel(s, &x, &y)
                          ? script_pick(&s->script, x, y)
                          : -1;
    const bool shape = item >= 0 && script_is_painted(&s->script.items[item]);
    mark(s, shape ? sheet_count_shapes(&s->script, (size_t)item) : -1);
    return VIEW_CHANGED;
}

static void set_fill(struct style *style, int fill)
{
    style->fill = (enum fill)fill;
}

static void fade(struct style *style, int steps)
{
    const int alpha = style->alpha + 17 * steps;
    style->alpha = (uint8_t)pel_max(0, pel_min(alpha, 255));
}

/* Changes the picked shape, or all where none is picked. */
static enum view_action change(struct sheet *s, void (*by)(struct style *, int),
                               int how)
{
    for (int i = 0; i < s->shapes; i++)
        if (s->picked < 0 || s->picked == i)
            by(&s->style[i], how);
    return VIEW_CHANGED;
}

/* Keys that choose what is shown of the picture. */
static enum view_action press_show(struct sheet *s, int key)
{
    struct inspect *show = &s->inspect;
    const struct {
        int key;
        bool *is_on;
    } switches[] = {
        {' ', &s->moving},   {'o', &show->heat},      {'b', &show->bands},
        {'d', &show->areas}, {'m', &show->magnifier}, {'i', &show->numbers},
        {'h', &show->help},  {'s', &show->smooth},
    };
    for (size_t i = 0; i < sizeof switches / sizeof switches[0]; i++)
        if (switches[i].key == key) {
            *switches[i].is_on = !*switches[i].is_on;
            return VIEW_CHANGED;
        }
    if (key == 'x')
        show->format = (show->format + 1) % INSPECT_FORMATS;
    else if (key == PEL_KEY_F1 + 1)
        s->zoom = pel_max(1, s->zoom - 1);
    else if (key == PEL_KEY_F1 + 2)
        s->zoom = pel_min(s->zoom + 1, ZOOM_MOST);
    else
        return VIEW_NOTHING;
    return VIEW_CHANGED;
}

static enum view_action press_pick(struct sheet *s, int key)
{
    switch (key) {
    case PEL_KEY_TAB:
    case PEL_KEY_RIGHT:
        mark(s, s->picked + 1 < s->shapes ? s->picked + 1 : -1);
        return VIEW_CHANGED;
    case PEL_KEY_LEFT:
        mark(s, s->picked >= 0 ? s->picked - 1 : s->shapes - 1);
        return VIEW_CHANGED;
    case PEL_KEY_ENTER:
        mark(s, -1);
        return VIEW_CHANGED;
    default:
        return press_show(s, key);
    }
}

static enum view_action press(struct sheet *s, int key)
{
    switch (key) {
    case 'q':
    case PEL_KEY_ESCAPE:
        return VIEW_END;
    case 'w':
        return VIEW_SAVE;
    case '1':
    case '2':
    case '3':
    case '4':
        return change(s, set_fill, FILL_FLAT + key - '1');
    case '0':
        if (s->path)
            return change(s, set_fill, FILL_OWN);
        mark(s, -1);
        figures_styles(s->style);
        return VIEW_CHANGED;
    case '+':
    case '=':
    case PEL_KEY_UP:
        return change(s, fade, 1);
    case '-':
    case PEL_KEY_DOWN:
        return change(s, fade, -1);
    default:
        return press_pick(s, key);
    }
}

static void point(struct sheet *s, int x, int y)
{
    s->pointer[0] = pel_max(0, pel_min(x, s->width - 1));
    s->pointer[1] = pel_max(0, pel_min(y, s->height - 1));
}

enum view_action sheet_take(struct sheet *s, const struct pel_input *input)
{
    const bool down = input->state == PEL_INPUT_DOWN;
    switch (input->kind) {
    case PEL_INPUT_KEY:
        return input->state == PEL_INPUT_UP ? VIEW_NOTHING
                                            : press(s, input->code);
    case PEL_INPUT_MOVE:
        point(s, s->pointer[0] + input->x, s->pointer[1] + input->y);
        return s->inspect.magnifier ? VIEW_CHANGED : VIEW_NOTHING;
    case PEL_INPUT_POINT:
        point(s, input->x, input->y);
        return s->inspect.magnifier ? VIEW_CHANGED : VIEW_NOTHING;
    case PEL_INPUT_BUTTON:
        return down && input->code == 1 ? pick(s) : VIEW_NOTHING;
    case PEL_INPUT_TOUCH:
        point(s, input->x, input->y);
        return down ? pick(s) : VIEW_NOTHING;
    case PEL_INPUT_WHEEL:
        return input->y ? change(s, fade, input->y) : VIEW_NOTHING;
    default:
        return VIEW_NOTHING;
    }
}
