/* pel view: turns a mesh in a window or on a device. */
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "sim/cli/message.h"
#include "sim/cli/option_text.h"
#include "sim/mesh/pel2d.h"
#include "sim/render/scene_options.h"
#include "sim/view/displays.h"

struct view_options {
    struct device_options device;
    struct scene_options scene;
    struct viewer_options viewer;
};

enum { OPTION_FRAMES = 0x200, OPTION_STEP, OPTION_STILL };

static const struct argp_option options[] = {
    {"frames", OPTION_FRAMES, "N", 0,
     "draw N frames as fast as it goes, print their rate, and end", 0},
    {"step", OPTION_STEP, "DEGREES", 0,
     "turn by so much from frame to frame, whatever the time", 0},
    {"still", OPTION_STILL, NULL, 0, "do not turn until space is pressed", 0},
    {"output", 'o', "FILE", 0, "write the last picture: .ppm, .png or .bmp", 0},
    {0},
};

static bool parse_step(const char *text, struct viewer_options *o)
{
    static const struct option_numbers numbers = {
        1, 0, -360, 360, "degrees from -360 to 360, such as 7.5,"};
    double degrees = 0;
    const bool right = option_numbers("--step", text, &numbers, &degrees);
    o->has_step = true;
    o->step = degrees / 360;
    return right;
}

static bool parse_mesh(const char *text, struct view_options *o)
{
    if (o->scene.source.path)
        return message_error("'%s' is a second mesh; one would be right", text);
    o->scene.source.path = text;
    return true;
}

static bool parse_value(int key, const char *text, struct viewer_options *o)
{
    switch (key) {
    case OPTION_FRAMES:
        return option_integer("--frames", text, 1, 1000000, &o->frames);
    case OPTION_STEP:
        return parse_step(text, o);
    case OPTION_STILL:
        o->still = true;
        return true;
    default:
        o->output = text;
        return picture_path_check(text);
    }
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct view_options *o = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &o->scene;
        state->child_inputs[1] = &o->device;
        return 0;
    case ARGP_KEY_ARG:
        return parse_mesh(text, o) ? 0 : EINVAL;
    case OPTION_FRAMES:
    case OPTION_STEP:
    case OPTION_STILL:
    case 'o':
        return parse_value(key, text, &o->viewer) ? 0 : EINVAL;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/* The help of the keys, which argp's text cannot name: it is no constant. */
static char *filter_help(int key, const char *text, void *input)
{
    char *with_keys = NULL;
    (void)input;
    if (key != ARGP_KEY_HELP_POST_DOC)
        return (char *)text;
    return asprintf(&with_keys, "%s\n\nKeys:\n%s\n", text, view_keys_help) < 0
               ? (char *)text
               : with_keys;
}

static const struct argp_child children[] = {
    {&scene_argp, 0, NULL, 1}, {&device_argp, 0, NULL, 0}, {0}};

static const struct argp parser = {
    .options = options,
    .parser = parse,
    .args_doc = "[MESH]",
    .doc = "Turns a mesh in a window, or on a device.\v"
           "MESH is a file that assimp reads, or " MESH_BUILTIN
           " (when left out). The size is that of the screen on a device, "
           "800x800 in a window, unless --size names one; --jobs is 0 unless "
           "given.",
    .children = children,
    .help_filter = filter_help,
};

static bool check(const char *path)
{
    const char *dot = strrchr(path, '.');
    if (dot && strcmp(dot, ".pel") == 0)
        return message_error_at(path, 0,
                                "is a scene script; `pel run` draws it, and a "
                                "mesh would be right");
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

void view_tell_keys(const struct viewer_options *o)
{
    if (o->frames == 0)
        fputs(view_keys_help, stderr);
}

int view_jobs(int jobs)
{
    return jobs > 0 ? jobs : pel_pool_processors();
}

int command_view(int argc, char **argv)
{
    struct view_options o = {.scene = {.settings = scene_default}};
    o.scene.settings.camera.width = o.scene.settings.camera.height = 0;
    arguments_parse(&parser, argc, argv, &o);
    if (!o.scene.source.path)
        o.scene.source.path = MESH_BUILTIN;
    o.scene.source.without_texture = false; /* there is a key for it */
    return run(&o) ? STATUS_OK : STATUS_ERROR;
}
