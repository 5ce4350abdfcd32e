/* pel demo: draws the gallery. */
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "sim/cli/arguments.h"
#include "sim/image/canvas.h"
#include "sim/cli/commands.h"
#include "sim/demo/demo.h"
#include "sim/demo/index.h"
#include "sim/cli/message.h"
#include "sim/cli/milliseconds.h"
#include "sim/script/script.h"

static const char about[] =
    "Draws the gallery into a directory: every demo and every script, as PPM "
    "and PNG (BMP without libpng), with index.html.\v"
    "Prints the milliseconds that the drawing of each picture took, the best "
    "of three where it is less than 50.";

static bool save_as(const char *directory, const char *name, const char *ending,
                    const struct picture *picture)
{
    char *path;
    if (asprintf(&path, "%s/%s%s", directory, name, ending) < 0)
        return message_error("out of memory");
    const bool done = picture_save(picture, path);
    free(path);
    return done;
}

static bool add_picture(struct demo_index *index, const struct demo *demo,
                        const struct demo_result *result)
{
    const struct picture *p = &result->picture;
    printf("%-26s %5d x %-5d %10.3f ms\n", demo->name, p->width, p->height,
           result->milliseconds);
    fflush(stdout);
    demo_index_add(index, demo, result);
    return save_as(index->directory, demo->name, ".ppm", p) &&
           save_as(index->directory, demo->name, picture_best_ending(), p);
}

/* One picture of a demo or a script, from nothing. */
typedef bool draw_function(const void *what, struct demo_result *result);

static bool draw_demo(const void *what, struct demo_result *result)
{
    const struct demo *demo = what;
    return demo->draw(result, demo->which);
}

static bool draw_script(const void *what, struct demo_result *result)
{
    const struct script *script = what;
    struct canvas canvas;
    if (!canvas_init(&canvas, script->format, script->width, script->height))
        return false;
    const double start = milliseconds();
    bool done = script_draw(script, &canvas, -1);
    result->milliseconds = milliseconds() - start;
    done = done && canvas_picture(&canvas, &result->picture);
    canvas_free(&canvas);
    return done;
}

/* The first run of a short drawing pays for cold caches and fresh pages: three
 * runs, and the time of the best. */
static bool draw_best(draw_function *draw, const void *what,
                      struct demo_result *best)
{
    bool done = draw(what, best);
    for (int i = 1; done && i < 3 && best->milliseconds < 50; i++) {
        struct demo_result again = {{0, 0, NULL}, 0, ""};
        done = draw(what, &again);
        if (again.milliseconds < best->milliseconds)
            best->milliseconds = again.milliseconds;
        picture_free(&again.picture);
    }
    return done;
}

static bool add_demos(struct demo_index *index, const struct demo *demo)
{
    bool done = true;
    for (; done && demo->name; demo++) {
        struct demo_result result = {{0, 0, NULL}, 0, ""};
        done = draw_best(draw_demo, demo, &result) &&
               add_picture(index, demo, &result);
        picture_free(&result.picture);
    }
    return done;
}

/* The name of a script without folder and ending. */
static void name_of(const char *path, char *name, size_t size)
{
    const char *slash = strrchr(path, '/');
    snprintf(name, size, "%s", slash ? slash + 1 : path);
    char *dot = strrchr(name, '.');
    if (dot && dot > name)
        *dot = '\0';
}

static bool add_script(struct demo_index *index, const char *path)
{
    char name[128], caption[1024];
    struct demo_result result = {{0, 0, NULL}, 0, ""};
    struct script script;
    if (!script_load(&script, path, NULL))
        return false;
    name_of(path, name, sizeof name);
    demo_index_escape(script.caption, caption, sizeof caption);
    const struct demo demo = {name, caption, NULL, 0};
    const bool done = draw_best(draw_script, &script, &result) &&
                      add_picture(index, &demo, &result);
    picture_free(&result.picture);
    script_free(&script);
    return done;
}

static bool add_all(struct demo_index *index, char **scripts)
{
    bool done = true;
    for (; done && *scripts; scripts++)
        done = add_script(index, *scripts);
    return done && add_demos(index, demo_formats) &&
           add_demos(index, demo_rules) && add_demos(index, demo_duck) &&
           add_demos(index, demo_texture) && add_demos(index, demo_lighting);
}

int command_demo(int argc, char **argv)
{
    struct demo_index index;
    const struct command_line line = {.arguments = "DIRECTORY [SCRIPT...]",
                                      .least = 1,
                                      .most = INT_MAX,
                                      .about = about};
    char **arguments = arguments_parse(&line, argc, argv);
    const char *directory = *arguments;
    if (mkdir(directory, 0777) != 0 && errno != EEXIST) {
        message_error_at(directory, 0, "cannot be made: %s", strerror(errno));
        return STATUS_ERROR;
    }
    if (!demo_index_open(&index, directory))
        return STATUS_ERROR;
    if (!add_all(&index, arguments + 1)) {
        demo_index_abandon(&index);
        return STATUS_ERROR;
    }
    return demo_index_commit(&index) ? STATUS_OK : STATUS_ERROR;
}
