/* pel console: repairs a console that a program left broken. */

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "drivers/console_linux.h"
#include "sim/cli/message.h"

struct console_options {
    const char *terminal; /* NULL: none was named */
    bool reset;
};

static const struct option_row options[] = {
    {"reset", NULL, "text mode, normal keyboard, echo and cursor again",
     OPTION_FLAG, .offset = offsetof(struct console_options, reset)},
    {"tty", "/dev/ttyN",
     "this terminal instead of your own, or over ssh the one that is shown",
     OPTION_TEXT, .offset = offsetof(struct console_options, terminal)},
    {.help = NULL},
};

int command_console(int argc, char **argv)
{
    struct console_options o = {NULL, false};
    struct pel_message message;
    const struct command_line line = {
        .arguments = "--reset",
        .about = "Repairs a console that something else left in graphics mode, "
                 "or deaf.\v"
                 "Type it blindly on that console, or run it from ssh as root.",
        .tables = {{options, &o, NULL}}};
    arguments_parse(&line, argc, argv);
    if (!o.reset) {
        message_error("nothing to do: expected pel console --reset");
        return STATUS_ERROR;
    }
    if (pel_console_reset(o.terminal, &message) == 0)
        return STATUS_OK;
    message_error("%s", message.text);
    return STATUS_ERROR;
}
