/* What the user does, from whatever device, in a window or on a screen. */
#include <stdio.h>

#include "sim/cli/message.h"
#include "sim/view/record.h"
#include "sim/view/viewer.h"

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

static void follow(struct viewer *viewer, const struct pel_input *event)
{
    const bool moves = event->kind == PEL_INPUT_MOVE;
    const int to[2] = {event->x, event->y};
    if (!moves && event->kind != PEL_INPUT_POINT)
        return;
    for (int k = 0; k < 2; k++) {
        const int at = to[k] + (moves ? viewer->pointer[k] : 0);
        viewer->pointer[k] = pel_max(0, pel_min(at, viewer->size[k] - 1));
    }
    viewer->has_pointer = viewer->pointed = true;
}

bool viewer_input(struct viewer *viewer, const struct pel_input *event)
{
    const enum view_action action = viewer->show->input(viewer->show, event);
    follow(viewer, event);
    if (viewer->record)
        record_write(viewer->record, viewer->steps, event);
    viewer->stale = viewer->stale || action == VIEW_CHANGED;
    viewer->over = viewer->over || action == VIEW_END;
    return action == VIEW_SAVE;
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
