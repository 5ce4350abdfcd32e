#include "sim/view/viewer.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "sim/cli/message.h"
#include "sim/cli/milliseconds.h"
#include "sim/view/record.h"

enum { IDLE_MS = 50 };

void viewer_init(struct viewer *viewer, struct show *show,
                 const struct viewer_options *options)
{
    *viewer = (struct viewer){.show = show, .options = options, .stale = true};
    if (options->record && show->period <= 0)
        show->period = RECORD_PERIOD;
}

/* The file is what it was before there is something to write, and has every
 * line at once: however the program ends, no line is lost. */
static bool record(struct viewer *viewer, const struct pel_input *event)
{
    const char *path = viewer->options->record;
    if (!path)
        return true;
    if (!viewer->record)
        viewer->record = fopen(path, "we");
    if (viewer->record) {
        record_write(viewer->record, viewer->steps, event);
        if (fflush(viewer->record) == 0)
            return true;
    }
    viewer->over = true;
    return message_error_at(path, 0, "cannot be written: %s", strerror(errno));
}

void viewer_free(struct viewer *viewer)
{
    pel_input_linux_close(&viewer->input);
    if (viewer->record)
        fclose(viewer->record);
}

bool viewer_resize(struct viewer *viewer, int width, int height)
{
    const struct pel_input size = {
        .kind = RECORD_SIZE, .x = (int16_t)width, .y = (int16_t)height};
    viewer->stale = true;
    viewer->size[0] = width;
    viewer->size[1] = height;
    return record(viewer, &size) &&
           viewer->show->resize(viewer->show, width, height);
}

bool viewer_is_over(const struct viewer *viewer)
{
    const int frames = viewer->options->frames;
    return viewer->over || (frames > 0 && viewer->drawn >= frames);
}

/* Measures once a second. */
static void measure(struct viewer *viewer, double now)
{
    const double passed = now - viewer->rate.since;
    const int drawn = viewer->drawn - viewer->rate.drawn;
    if (passed < 1000)
        return;
    viewer->rate.fps = drawn * 1000 / passed;
    viewer->rate.milliseconds =
        drawn ? (viewer->drawing - viewer->rate.drawing) / drawn : 0;
    viewer->rate.since = now;
    viewer->rate.drawn = viewer->drawn;
    viewer->rate.drawing = viewer->drawing;
}

/* A step of time, when it is due: the one after it comes a period later, or at
 * once where that is over too. */
static bool step(struct viewer *viewer, double now)
{
    struct show *show = viewer->show;
    const bool counted = viewer->options->frames > 0;
    const double time =
        (counted && !viewer->options->record) || show->period <= 0
            ? now - viewer->last
            : show->period;
    if (!counted && now < viewer->due)
        return false;
    if (!counted && show->period > 0 && now >= viewer->due + show->period) {
        show->late += (int)((now - viewer->due) / show->period);
        viewer->due = now;
    }
    viewer->due += show->period;
    viewer->last = now;
    viewer->steps++;
    viewer->moves = show->advance(show, time);
    return viewer->moves;
}

void viewer_advance(struct viewer *viewer)
{
    const double now = milliseconds();
    if (viewer->begun == 0 && viewer->options->frames == 0)
        fputs(viewer->show->keys, stderr);
    if (viewer->drawn == 0) {
        viewer->begun = viewer->last = viewer->rate.since = now;
        viewer->due = now + viewer->show->period;
        return;
    }
    viewer->stale =
        step(viewer, now) || viewer->stale || viewer->options->frames > 0;
    measure(viewer, now);
}

int viewer_idle(const struct viewer *viewer)
{
    const double period = viewer->show->period;
    const double left = viewer->due - milliseconds();
    if (viewer->stale || viewer->options->frames > 0)
        return 0;
    if (period > 0)
        return left > 0 ? (int)left + 1 : 0;
    return viewer->moves ? 0 : IDLE_MS;
}

bool viewer_draw(struct viewer *viewer, const struct pel_surface *surface)
{
    const double start = milliseconds();
    viewer->show->changed = (struct pel_dirty_areas){
        .window = 256, .count = 1, .area = {surface->clip}};
    const bool done = viewer->show->draw(viewer->show, surface);
    viewer->show->draw_time = milliseconds() - start;
    viewer->drawing += viewer->show->draw_time;
    viewer->drawn++;
    viewer->stale = false;
    return done;
}

bool viewer_save(const struct viewer *viewer, const struct pel_surface *surface,
                 bool last)
{
    const struct canvas canvas = {.surface = *surface};
    const char *output = viewer->options->output;
    char path[32];
    if (last)
        return !output || canvas_save(&canvas, output);
    for (int i = 1; i < 1000; i++) {
        snprintf(path, sizeof(path), "view-%03d%s", i, picture_best_ending());
        if (access(path, F_OK) != 0)
            return canvas_save(&canvas, path) &&
                   fprintf(stderr, "written: %s\n", path) > 0;
    }
    return message_error("view-001 to view-999 are there already: expected a "
                         "free name");
}

void viewer_title(const struct viewer *viewer, char title[VIEWER_TITLE_SIZE])
{
    char text[SHOW_TITLE_SIZE], speed[64] = "";
    viewer->show->title(viewer->show, text);
    if (viewer->moves && viewer->rate.fps > 0)
        snprintf(speed, sizeof speed, "%.1f fps (drawing %.1f ms), ",
                 viewer->rate.fps, viewer->rate.milliseconds);
    snprintf(title, VIEWER_TITLE_SIZE, "pel view: %s%s", speed, text);
}

void viewer_report(const struct viewer *viewer)
{
    const double passed = milliseconds() - viewer->begun;
    if (viewer->drawn > 0)
        fprintf(stderr, "%d frames, %.1f fps, drawing %.3f ms a frame\n",
                viewer->drawn, viewer->drawn * 1000 / passed,
                viewer->drawing / viewer->drawn);
}

bool viewer_open_input(struct viewer *viewer,
                       const struct pel_input_linux_options *options)
{
    struct pel_input_linux *input = &viewer->input;
    if (pel_input_linux_open(input, options))
        return message_error("%s", input->message.text);
    if (input->note.text[0])
        message_error("%s", input->note.text);
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
    record(viewer, event);
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
