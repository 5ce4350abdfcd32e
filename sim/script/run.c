/* pel run: draws a script. */

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "sim/cli/device.h"
#include "sim/script/script.h"

struct run_options {
    struct device_options device;
    const char *output;
    const struct pel_format *format; /* NULL: the script's */
    int bands;                       /* -1: the script's */
    struct script script;
};

static const struct option_row options[] = {
    {"bands", "ROWS",
     "draw in bands of so many rows (0: whole), whatever the script says",
     OPTION_INTEGER, .offset = offsetof(struct run_options, bands), .low = 0,
     .high = 32767},
    {"format", "NAME", "draw in this pixel format, whatever the script says",
     OPTION_FORMAT, .offset = offsetof(struct run_options, format)},
    {.help = NULL},
};

static const char about[] =
    "Draws a script into a picture.\v"
    "A script holds one command a line: canvas WIDTH HEIGHT FORMAT first, then "
    "clear, clip, paint, shapes from triangle to arc, outline, text, image, "
    "scroll, mesh and others: sim/scenes/README.md describes them. SCRIPT - is "
    "standard input; the picture goes to standard output without -o.";

static bool draw_script(struct canvas *canvas, const void *context)
{
    const struct run_options *o = context;
    return script_draw(&o->script, canvas, o->bands);
}

int command_run(int argc, char **argv)
{
    struct run_options o = {.device = {.jobs = 1}, .output = "-", .bands = -1};
    const struct command_line line = {
        .arguments = "SCRIPT",
        .least = 1,
        .most = 1,
        .about = about,
        .tables = {{output_option_table, &o.output, NULL},
                   {options, &o, NULL},
                   {device_option_table, &o.device, NULL}}};
    char **script_path = arguments_parse(&line, argc, argv);
    if (!picture_path_check(o.output) ||
        !device_check_output(&o.device, o.output) ||
        !script_load(&o.script, *script_path, o.format))
        return STATUS_ERROR;
    if (script_needs_whole(&o.script))
        o.device.jobs = 1;
    const struct device_picture picture = {o.script.width, o.script.height,
                                           &o.script.format, draw_script, &o};
    const bool done = device_show(&o.device, &picture, o.output);
    script_free(&o.script);
    return done ? STATUS_OK : STATUS_ERROR;
}
