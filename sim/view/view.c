/* pel view: turns a mesh in a window or on a device. */
#include <stdio.h>
#include <string.h>

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "sim/cli/message.h"
#include "sim/mesh/pel2d.h"
#include "sim/render/scene_options.h"
#include "sim/view/viewer.h"

struct view_options {
    struct device_options device;
    struct scene_options scene;
    struct viewer_options viewer;
};

static bool parse_step(const char *option, const char *text, void *input)
{
    struct viewer_options *o = input;
    static const struct option_row numbers = {.n = 1, .low = -360, .high = 360};
    double degrees = 0;
    o->has_step = true;
    if (!option_numbers(text, &numbers, &degrees))
        return option_refuse(option, text,
                             "degrees from -360 to 360, such as 7.5");
    o->step = degrees / 360;
    return true;
}

static const struct option_row options[] = {
    {"frames", "N",
     "draw N frames as fast as it goes, print their rate, and end",
     OPTION_INTEGER, .offset = offsetof(struct viewer_options, frames),
     .low = 1, .high = 1000000},
    {"step", "DEGREES",
     "turn by so much from frame to frame, whatever the time", OPTION_CALL,
     .parse = parse_step},
    {"still", NULL, "do not turn until space is pressed", OPTION_FLAG,
     .offset = offsetof(struct viewer_options, still)},
    {"buttons", "CHIP:LINES", "buttons at GPIO lines: see pel input --help",
     OPTION_TEXT, .offset = offsetof(struct viewer_options, buttons)},
    {.help = NULL},
};

static const char about[] =
    "Turns a mesh in a window, or on a device.\v"
    "MESH is a file that assimp reads, or " MESH_BUILTIN
    " (when left out). The size is that of the screen on a device, 800x800 in "
    "a window, unless --size names one; --jobs is 0 unless given; -o takes the "
    "last picture.\n\nKeys:\n" VIEW_KEYS_HELP;

static bool check(const char *path)
{
    const char *dot = strrchr(path, '.');
    if (dot && strcmp(dot, ".pel") == 0)
        return message_error_at(path, 0,
                                "is a scene script, which `pel run` draws: "
                                "expected a mesh");
    return !pel2d_is_file(path) ||
           message_error_at(path, 0,
                            "is projected already and cannot be turned: "
                            "`pel render` draws it");
}

static bool run(const struct view_options *o)
{
    struct model model;
    const struct view_job job = {&model, &o->scene.settings, &o->viewer,
                                 &o->device};
    if (!check(o->scene.source.path) || !model_load(&model, &o->scene.source))
        return false;
    const bool done = o->device.name ? view_device(&job) : view_window(&job);
    model_free(&model);
    return done;
}

int command_view(int argc, char **argv)
{
    struct view_options o = {.scene = {.settings = scene_default}};
    o.scene.settings.camera.width = o.scene.settings.camera.height = 0;
    const struct command_line line = {
        .arguments = "[MESH]",
        .most = 1,
        .about = about,
        .tables = {{output_option_table, &o.viewer.output, NULL},
                   {options, &o.viewer, NULL},
                   {device_option_table, &o.device, NULL},
                   {scene_option_table, &o.scene, NULL}}};
    const char *path = *arguments_parse(&line, argc, argv);
    o.scene.source.path = path ? path : MESH_BUILTIN;
    if (o.viewer.output && !picture_path_check(o.viewer.output))
        return STATUS_ERROR;
    o.scene.source.without_texture = false; /* there is a key for it */
    return run(&o) ? STATUS_OK : STATUS_ERROR;
}
