/* pel view --headless: frames into files, with nobody watching. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/format/formats.h"
#include "sim/cli/message.h"
#include "sim/view/record.h"
#include "sim/view/viewer.h"

/* A canvas of a new size. */
static bool resize(struct show *show, struct canvas *canvas, int width,
                   int height)
{
    canvas_free(canvas);
    return canvas_init(canvas, &pel_xrgb8888, width, height) &&
           show->resize(show, width, height);
}

/* A run of frames. */
struct run {
    struct show *show;
    struct canvas canvas;
    struct record record;
    const char *directory;
    int saved; /* pictures that the user wrote */
    bool over; /* the user ended it */
};

/* Draws frame-0000.ppm and so on; or view-001.ppm, what the user writes. */
static bool draw(struct run *r, const char *name, int digits, int number)
{
    char *path;
    if (asprintf(&path, "%s/%s%0*d.ppm", r->directory, name, digits, number) <
        0)
        return message_error("out of memory");
    const bool done = r->show->draw(r->show, &r->canvas.surface) &&
                      canvas_save(&r->canvas, path);
    free(path);
    return done;
}

/* What the user did before a frame. False, with a message. */
static bool take(struct run *r, int frame)
{
    const struct pel_input *input;
    bool done = true;
    while (done && !r->over && (input = record_next(&r->record, frame))) {
        if (input->kind == RECORD_SIZE) {
            done = resize(r->show, &r->canvas, input->x, input->y);
            continue;
        }
        const enum view_action action = r->show->input(r->show, input);
        r->over = action == VIEW_END;
        if (action == VIEW_SAVE)
            done = draw(r, "view-", 3, ++r->saved);
    }
    return done;
}

static bool run(struct run *r, const struct viewer_options *o)
{
    struct show *show = r->show;
    const double period = show->period > 0 ? show->period : RECORD_PERIOD;
    bool done = resize(show, &r->canvas, o->width ? o->width : show->width,
                       o->height ? o->height : show->height);
    for (int frame = 0; done && !r->over && frame < o->frames; frame++) {
        if (frame > 0)
            show->advance(show, period);
        done = take(r, frame) && (r->over || draw(r, "frame-", 4, frame));
    }
    canvas_free(&r->canvas);
    return done;
}

bool view_headless(struct show *show, const struct viewer_options *o)
{
    struct run r = {.show = show, .directory = o->output};
    if (mkdir(o->output, 0777) != 0 && errno != EEXIST)
        return message_error_at(o->output, 0, "cannot be made: %s",
                                strerror(errno));
    const bool done =
        (!o->replay || record_load(&r.record, o->replay)) && run(&r, o);
    record_free(&r.record);
    return done;
}
