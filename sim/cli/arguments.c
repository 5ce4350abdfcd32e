#include "sim/cli/arguments.h"

#include <errno.h>
#include <stdlib.h>

#include "sim/cli/child.h"
#include "sim/cli/commands.h"

enum { OPTION_LIMIT = 0x800 };

static const struct argp_option options[] = {
    {"limit", OPTION_LIMIT, "SECONDS,MEGABYTES", 0,
     "that reading a file through a library may take: a mesh, or a picture "
     "other than .ppm (default: 60,2048)",
     -1},
    {0},
};

struct root_input {
    char **argv;
    void *input;
};

/* Takes the real arguments; see arguments_parse. */
static error_t parse_root(int key, char *text, struct argp_state *state)
{
    const struct root_input *root = state->input;
    if (key == OPTION_LIMIT)
        return child_limits_parse(text) ? 0 : EINVAL;
    if (key != ARGP_KEY_INIT)
        return ARGP_ERR_UNKNOWN;
    state->argv = root->argv;
    state->child_inputs[0] = root->input;
    return 0;
}

/* Messages of getopt begin with argv[0], which is to be "pel"; help shows the
 * program's invocation name, "pel NAME", where argv is not that of the call. */
void arguments_parse(const struct argp *argp, int argc, char **argv,
                     void *input)
{
    static char program[] = "pel";
    const struct argp_child children[] = {{argp, 0, NULL, 0}, {0}};
    const struct argp root = {
        .options = options, .parser = parse_root, .children = children};
    struct root_input names = {argv, input};
    char *unused[] = {program, NULL};
    program_invocation_short_name = argv[0];
    argv[0] = program;
    argp_err_exit_status = STATUS_ERROR;
    if (argp_parse(&root, argc, unused, 0, NULL, &names) != 0)
        exit(STATUS_ERROR);
}
