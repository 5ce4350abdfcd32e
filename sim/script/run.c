/* pel run: draws a script. */

#include <errno.h>

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "sim/cli/device.h"
#include "sim/cli/message.h"
#include "sim/cli/option_text.h"
#include "sim/script/script.h"

struct run_options {
    struct device_options device;
    const char *script, *output;
    const struct pel_format *format; /* NULL: the script's */
    int bands;                       /* -1: the script's */
};

enum { OPTION_BANDS = 0x100, OPTION_FORMAT };

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0,
     "the picture: .ppm, .png or .bmp; standard output when left out", 0},
    {"bands", OPTION_BANDS, "ROWS", 0,
     "draw in bands of so many rows (0: whole), whatever the script says", 0},
    {"format", OPTION_FORMAT, "NAME", 0,
     "draw in this pixel format, whatever the script says", 0},
    {0},
};

static bool parse_script(const char *text, struct run_options *o)
{
    if (o->script)
        return message_error("one script only, not %s too", text);
    o->script = text;
    return true;
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    struct run_options *o = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &o->device;
        return 0;
    case 'o':
        o->output = text;
        return 0;
    case OPTION_BANDS:
        return option_integer("--bands", text, 0, 32767, &o->bands) ? 0
                                                                    : EINVAL;
    case OPTION_FORMAT:
        return option_format(text, &o->format) ? 0 : EINVAL;
    case ARGP_KEY_ARG:
        return parse_script(text, o) ? 0 : EINVAL;
    case ARGP_KEY_NO_ARGS:
        message_error("a script is missing; - is standard input");
        return EINVAL;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_child children[] = {{&device_argp, 0, NULL, 0}, {0}};

static const struct argp parser = {
    options,
    parse_option,
    "SCRIPT",
    "Draws a script into a picture.\v"
    "A script holds one command a line: canvas WIDTH HEIGHT FORMAT first, then "
    "clear, clip, paint, shapes from triangle to arc, outline, text, image, "
    "scroll, mesh and others: sim/scenes/README.md describes them.",
    children,
    NULL,
    NULL,
};

struct drawing {
    struct script *script;
    int bands;
};

static bool draw_script(struct canvas *canvas, const void *context)
{
    const struct drawing *drawing = context;
    return script_draw(drawing->script, canvas, drawing->bands);
}

static bool show(const struct run_options *o, struct script *script)
{
    const struct drawing drawing = {script, o->bands};
    const struct device_picture picture = {
        .width = script->width,
        .height = script->height,
        .format = &script->format,
        .draw = draw_script,
        .context = &drawing,
    };
    return device_show(&o->device, &picture, o->output);
}

int command_run(int argc, char **argv)
{
    struct run_options o = {.device = {.jobs = 1}, .output = "-", .bands = -1};
    struct script script;
    arguments_parse(&parser, argc, argv, &o);
    if (!picture_path_check(o.output) ||
        !device_check_output(&o.device, o.output) ||
        !script_load(&script, o.script, o.format))
        return STATUS_ERROR;
    if (script_needs_whole(&script))
        o.device.jobs = 1;
    const bool done = show(&o, &script);
    script_free(&script);
    return done ? STATUS_OK : STATUS_ERROR;
}
