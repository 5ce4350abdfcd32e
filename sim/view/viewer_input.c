/* What the user does, from whatever device, in a window or on a screen. */
#include <stdio.h>
#include <stdlib.h>

#include "sim/cli/message.h"
#include "sim/view/viewer.h"

enum { MOST_NOTCHES = 16 };

bool viewer_open_input(struct viewer *viewer,
                       const struct pel_input_linux_options *options)
{
    struct pel_input_linux *input = &viewer->input;
    if (pel_input_linux_open(input, options))
        return message_error("%s", input->message.text);
    if (input->note.text[0])
        fprintf(stderr, "pel: %s\n", input->note.text);
    return true;
}

static bool press(struct viewer *viewer, int key)
{
    const enum view_action action = view_key(&viewer->view, key);
    viewer->stale = viewer->stale || action == VIEW_CHANGED;
    viewer->over = viewer->over || action == VIEW_END;
    return action == VIEW_SAVE;
}

/* As many times as a wheel was turned by notches. */
static void press_often(struct viewer *viewer, int notches, int up, int down)
{
    for (int i = 0; i < abs(notches) && i < MOST_NOTCHES; i++)
        press(viewer, notches > 0 ? up : down);
}

/* Half a turn from one side of the picture to the other. */
static void drag(struct viewer *viewer, int x, int y)
{
    if (!viewer->dragging || viewer->width <= 0)
        return;
    view_orbit(&viewer->view, x * 0.5 / viewer->width,
               y * 0.5 / viewer->height);
    viewer->stale = true;
}

static void drag_to(struct viewer *viewer, const struct pel_input *e)
{
    drag(viewer, e->x - viewer->x, e->y - viewer->y);
    viewer->x = e->x;
    viewer->y = e->y;
}

static void touch(struct viewer *viewer, const struct pel_input *e)
{
    if (e->code != 0)
        return;
    viewer->dragging = viewer->dragging && e->state == PEL_INPUT_AGAIN;
    drag_to(viewer, e);
    viewer->dragging = e->state != PEL_INPUT_UP;
}

bool viewer_input(struct viewer *viewer, const struct pel_input *e)
{
    switch (e->kind) {
    case PEL_INPUT_LOST:
        viewer->dragging = false;
        break;
    case PEL_INPUT_KEY:
        return e->state != PEL_INPUT_UP && press(viewer, e->code);
    case PEL_INPUT_BUTTON:
        if (e->code == 1)
            viewer->dragging = e->state != PEL_INPUT_UP;
        break;
    case PEL_INPUT_MOVE:
        drag(viewer, e->x, e->y);
        break;
    case PEL_INPUT_POINT:
        drag_to(viewer, e);
        break;
    case PEL_INPUT_TOUCH:
        touch(viewer, e);
        break;
    case PEL_INPUT_WHEEL:
        press_often(viewer, e->y, '+', '-');
        press_often(viewer, e->x, PEL_KEY_RIGHT, PEL_KEY_LEFT);
        break;
    default:
        break;
    }
    return false;
}

bool viewer_inputs(struct viewer *viewer)
{
    struct pel_input event;
    bool save = false;
    if (viewer->input.queue.size == 0)
        return false;
    while (!save && pel_input_linux_next(&viewer->input, &event))
        save = viewer_input(viewer, &event);
    return save;
}
