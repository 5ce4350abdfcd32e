/* pel view: shows a mesh, a script or figures in a window, on a device or in
 * files, and takes what the user does. */
#include <stdio.h>
#include <string.h>

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "sim/cli/message.h"
#include "sim/mesh/pel2d.h"
#include "sim/render/scene_options.h"
#include "sim/view/sheet.h"
#include "sim/view/turntable.h"
#include "sim/view/viewer.h"

struct view_options {
    struct device_options device;
    struct scene_options scene;
    struct viewer_options viewer;
    bool has_step; /* not by the clock: */
    double step;   /* degrees that a mesh turns from frame to frame */
    bool still;    /* no movement at the start */
};

#define AT(member) offsetof(struct view_options, member)

static const struct option_row options[] = {
    {"frames", "N",
     "draw N frames as fast as it goes, print their rate, and end",
     OPTION_INTEGER, .offset = AT(viewer.frames), .low = 1, .high = 1000000},
    {"headless", NULL,
     "no window: write --frames frames to the folder -o, as frame-0000.ppm and "
     "so on",
     OPTION_FLAG, .offset = AT(viewer.headless)},
    {"record", "FILE", "write what the user does to a file", OPTION_TEXT,
     .offset = AT(viewer.record)},
    {"replay", "FILE",
     "for --headless: do what was recorded; key w writes view-001.ppm and so "
     "on to the folder",
     OPTION_TEXT, .offset = AT(viewer.replay)},
    {"step", "DEGREES",
     "turn a mesh by so much from frame to frame, whatever the time",
     OPTION_NUMBERS, .offset = AT(step), .flag = AT(has_step), .n = 1,
     .low = -360, .high = 360,
     .expected = "degrees from -360 to 360, such as 7.5"},
    {"still", NULL, "nothing moves until space is pressed", OPTION_FLAG,
     .offset = AT(still)},
    {"buttons", "CHIP:LINES", "buttons at GPIO lines: see pel input --help",
     OPTION_TEXT, .offset = AT(viewer.buttons)},
    {.help = NULL},
};

static const char about[] =
    "Shows a mesh, a scene script or figures, and takes keys, mouse, touch and "
    "buttons.\v"
    "MESH is a file that assimp reads, or one of " MESH_BUILTINS
    " (when left out); SCRIPT.pel is a scene script, whose shapes can be "
    "picked and painted; figures are built in. The size is that of the screen "
    "on a device, 800x800 in a window, unless --size names one; --jobs is 0 "
    "unless given; -o takes the last picture.\n\n"
    "Keys for meshes:\n" VIEW_KEYS_HELP
    "\nKeys for scripts and figures:\n" SHEET_KEYS_HELP;

static bool show(struct show *show, const struct view_options *o)
{
    return o->viewer.headless ? view_headless(show, &o->viewer)
           : o->device.name   ? view_device(show, &o->viewer)
                              : view_window(show, &o->viewer);
}

static bool run_mesh(const struct view_options *o)
{
    struct model model;
    struct turntable t;
    if (pel2d_is_file(o->scene.source.path))
        return message_error_at(o->scene.source.path, 0,
                                "is projected already and cannot be turned: "
                                "`pel render` draws it");
    if (!model_load(&model, &o->scene.source))
        return false;
    bool done = turntable_init(&t, &model, &o->scene.settings, o->device.jobs);
    t.has_step = o->has_step;
    t.step = o->step / 360;
    t.view.turning = !o->still;
    done = done && show(&t.show, o);
    turntable_free(&t);
    model_free(&model);
    return done;
}

static bool run_sheet(const struct view_options *o, const char *path)
{
    struct sheet sheet;
    bool done = sheet_init(&sheet, path);
    sheet.moving = !o->still;
    done = done && show(&sheet.show, o);
    sheet_free(&sheet);
    return done;
}

static bool check(const struct viewer_options *o)
{
    if (o->headless && (!o->output || o->frames == 0))
        return message_error("--headless without %s: expected --frames N -o "
                             "FOLDER",
                             o->output ? "--frames" : "-o");
    if (o->replay && !o->headless)
        return message_error("--replay is for --headless");
    if (o->record && o->headless)
        return message_error("--record is for a window or a device");
    return o->headless || !o->output || picture_path_check(o->output);
}

int command_view(int argc, char **argv)
{
    struct view_options o = {.scene = {.settings = scene_default}};
    struct camera *camera = &o.scene.settings.camera;
    camera->width = camera->height = 0;
    const struct command_line line = {
        .arguments = "[MESH|SCRIPT.pel|figures]",
        .most = 1,
        .about = about,
        .tables = {{output_option_table, &o.viewer.output, NULL},
                   {options, &o, NULL},
                   {device_option_table, &o.device, NULL},
                   {scene_option_table, &o.scene, NULL}}};
    const char *path = *arguments_parse(&line, argc, argv);
    o.scene.source.path = path ? path : MESH_BUILTIN;
    o.viewer.width = camera->width;
    o.viewer.height = camera->height;
    o.viewer.device = &o.device;
    if (!check(&o.viewer))
        return STATUS_ERROR;
    const bool is_figures = path && strcmp(path, "figures") == 0;
    const bool done = is_figures ? run_sheet(&o, NULL)
                      : path && path_has_ending(path, " .pel ")
                          ? run_sheet(&o, path)
                          : run_mesh(&o);
    return done ? STATUS_OK : STATUS_ERROR;
}
