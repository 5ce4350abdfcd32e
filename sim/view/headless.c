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

static bool save(const struct canvas *canvas, const char *directory, int frame)
{
    char *path;
    struct picture picture;
    if (asprintf(&path, "%s/frame-%04d.ppm", directory, frame) < 0)
        return message_error("out of memory");
    const bool done =
        canvas_picture(canvas, &picture) && picture_save(&picture, path);
    picture_free(&picture);
    free(path);
    return done;
}

/* A canvas of a new size. */
static bool resize(struct show *show, struct canvas *canvas, int width,
                   int height)
{
    canvas_free(canvas);
    return canvas_init(canvas, &pel_xrgb8888, width, height) &&
           show->resize(show, width, height);
}

/* What the user did before a frame. *over: ended it. False, with a message. */
static bool take(struct show *show, struct record *record, int frame,
                 struct canvas *canvas, bool *over)
{
    const struct pel_input *input;
    while (!*over && (input = record_next(record, frame))) {
        if (input->kind != RECORD_SIZE)
            *over = show->input(show, input) == VIEW_END;
        else if (!resize(show, canvas, input->x, input->y))
            return false;
    }
    return true;
}

static bool run(struct show *show, const struct viewer_options *o,
                struct record *record)
{
    struct canvas canvas = {.memory = NULL};
    bool over = false;
    bool done = resize(show, &canvas, o->width ? o->width : show->width,
                       o->height ? o->height : show->height);
    for (int frame = 0; done && !over && frame < o->frames; frame++) {
        if (frame > 0)
            show->advance(show,
                          show->period > 0 ? show->period : RECORD_PERIOD);
        done = take(show, record, frame, &canvas, &over) &&
               (over || (show->draw(show, &canvas.surface) &&
                         save(&canvas, o->output, frame)));
    }
    canvas_free(&canvas);
    return done;
}

bool view_headless(struct show *show, const struct viewer_options *o)
{
    struct record record = {NULL, 0, 0};
    if (mkdir(o->output, 0777) != 0 && errno != EEXIST)
        return message_error_at(o->output, 0, "cannot be made: %s",
                                strerror(errno));
    const bool done = (!o->replay || record_load(&record, o->replay)) &&
                      run(show, o, &record);
    record_free(&record);
    return done;
}
