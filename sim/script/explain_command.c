/* pel explain. */
#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "sim/cli/message.h"
#include "sim/cli/number.h"
#include "sim/script/script.h"

struct explain_options {
    struct script script;
    const struct pel_format *format; /* NULL: the script's */
    int at[2];                       /* the pixel's x, y */
    bool all;
};

static bool parse_pixel(const char *text, const char *axis, int size, int *to)
{
    int64_t value;
    if (number_integer(text, 0, size - 1, &value) != NUMBER_OK)
        return message_error("%s is '%s': expected a pixel in 0..%d", axis,
                             text, size - 1);
    *to = (int)value;
    return true;
}

static const struct option_row options[] = {
    {"all", NULL, "tell of commands that leave the pixel alone, too",
     OPTION_FLAG, .offset = offsetof(struct explain_options, all)},
    {"format", "NAME", "draw in this pixel format, whatever the script says",
     OPTION_FORMAT, .offset = offsetof(struct explain_options, format)},
    {.help = NULL},
};

int command_explain(int argc, char **argv)
{
    struct explain_options e = {.all = false};
    const struct command_line line = {
        .arguments = "SCRIPT X Y",
        .least = 3,
        .most = 3,
        .about = "Tells which commands of a script touch a pixel.\v"
                 "In order, with the paint, the colour that it brings, what "
                 "was there, what comes of it and the value in the canvas's "
                 "format; and, for shapes, the numbers by which the pixel "
                 "is covered or not.",
        .tables = {{options, &e, NULL}}};
    char **arguments = arguments_parse(&line, argc, argv);
    const bool done =
        script_load(&e.script, arguments[0], e.format) &&
        parse_pixel(arguments[1], "X", e.script.width, &e.at[0]) &&
        parse_pixel(arguments[2], "Y", e.script.height, &e.at[1]) &&
        script_explain(&e.script, e.at[0], e.at[1], e.all);
    script_free(&e.script);
    return done ? STATUS_OK : STATUS_ERROR;
}
