/* pel view --headless: frames into files, with nobody watching. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/format/formats.h"
#include "sim/cli/message.h"
#include "sim/view/record.h"
#include "sim/view/show.h"

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

/* What the user did before a frame. False: the user ended it. */
static bool take(struct show *show, struct record *record, int frame,
                 int size[2])
{
    const struct pel_input *input;
    while ((input = record_next(record, frame))) {
        if (input->kind == RECORD_SIZE) {
            size[0] = input->x;
            size[1] = input->y;
        } else if (show->input(show, input) == VIEW_END) {
            return false;
        }
    }
    return true;
}

/* A canvas of the size that the window has by now. */
static bool fit(struct show *show, struct canvas *canvas, const int size[2])
{
    const struct pel_rect *had = &canvas->surface.bounds;
    if (canvas->memory && had->x1 == size[0] && had->y1 == size[1])
        return true;
    canvas_free(canvas);
    if (!canvas_init(canvas, &pel_xrgb8888, size[0], size[1]))
        return false;
    show->resize(show, size[0], size[1]);
    return true;
}

bool view_headless(struct show *show, const struct headless_options *o)
{
    struct canvas canvas = {.memory = NULL};
    struct record record = {NULL, 0, 0};
    int size[2] = {o->width, o->height};
    bool done = !o->replay || record_load(&record, o->replay);
    if (done && mkdir(o->directory, 0777) != 0 && errno != EEXIST)
        done = message_error_at(o->directory, 0, "cannot be made: %s",
                                strerror(errno));
    for (int frame = 0; done && frame < o->frames; frame++) {
        if (frame > 0)
            show->advance(show, 1000 / 30.0);
        if (!take(show, &record, frame, size))
            break;
        done = fit(show, &canvas, size) && show->draw(show, &canvas.surface) &&
               save(&canvas, o->directory, frame);
    }
    canvas_free(&canvas);
    record_free(&record);
    return done;
}
