/* pel console: repairs a console that a program left broken. */

#include <errno.h>

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "drivers/console_linux.h"
#include "sim/cli/message.h"

struct console_options {
    const char *terminal; /* NULL: none was named */
    bool reset;
};

enum { OPTION_RESET = 0x100, OPTION_TTY };

static const struct argp_option options[] = {
    {"reset", OPTION_RESET, NULL, 0,
     "text mode, normal keyboard, echo and cursor again", 0},
    {"tty", OPTION_TTY, "/dev/ttyN", 0,
     "this terminal instead of your own, or over ssh the one that is shown", 0},
    {0},
};

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct console_options *o = state->input;
    switch (key) {
    case OPTION_RESET:
        o->reset = true;
        return 0;
    case OPTION_TTY:
        o->terminal = text;
        return 0;
    case ARGP_KEY_ARG:
        message_error("unknown argument %s: --reset is the one thing to do",
                      text);
        return EINVAL;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    options,
    parse,
    NULL,
    "Repairs a console that something else left in graphics mode, or deaf.\v"
    "Type it blindly on that console, or run it from ssh as root.",
    NULL,
    NULL,
    NULL,
};

int command_console(int argc, char **argv)
{
    struct console_options o = {NULL, false};
    struct pel_message message;
    arguments_parse(&parser, argc, argv, &o);
    if (!o.reset) {
        message_error("pel console does nothing by itself; pel console --reset "
                      "would be right");
        return STATUS_ERROR;
    }
    if (pel_console_reset(o.terminal, &message) == 0)
        return STATUS_OK;
    message_error("%s", message.text);
    return STATUS_ERROR;
}
