/* pel-atlas: lists its cases, and writes the figures of one as CSV. */
#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "atlas.h"

struct options {
    struct atlas atlas;
    bool list;
};

static const struct argp_option option_table[] = {
    {"list", 'l', 0, 0, "print the names of the cases", 0},
    {"quick", 'q', 0, 0, "take fewer samples", 0},
    {"seed", 's', "N", 0, "the set of samples (1)", 0},
    {"smallest", 'm', "METHOD", 0,
     "print the smallest triangle that METHOD draws wrong in the case, as a "
     "scene script",
     0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct options *o = state->input;
    char *end = NULL;
    switch (key) {
    case 'l':
        o->list = true;
        return 0;
    case 'q':
        o->atlas.quick = true;
        return 0;
    case 's':
        o->atlas.seed = (uint32_t)strtoul(arg, &end, 10);
        if (*end || !*arg)
            argp_error(state, "--seed is a number, not %s", arg);
        return 0;
    case 'm':
        o->atlas.smallest = arg;
        return 0;
    case ARGP_KEY_ARG:
        if (o->atlas.name)
            argp_error(state, "one case at a time, not %s too", arg);
        o->atlas.name = arg;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static int list(void)
{
    for (const struct atlas_case *c = atlas_cases; c->name; c++)
        puts(c->name);
    return 0;
}

static int run(struct atlas *a)
{
    for (const struct atlas_case *c = atlas_cases; c->name; c++) {
        if (!a->name || strcmp(c->name, a->name) != 0)
            continue;
        if (!a->smallest)
            puts("case,method,x,y,metric,value,low,high,unit,command");
        c->run(a);
        if (fflush(stdout))
            method_fail("standard output", "write to a disk with free space");
        return a->broken != 0;
    }
    fprintf(stderr, "pel-atlas: no case %s; --list prints the names\n",
            a->name ? a->name : "named");
    return 2;
}

int main(int argc, char **argv)
{
    struct options o = {.atlas = {.seed = 1}};
    const struct argp argp = {option_table,
                              parse,
                              "CASE",
                              "Measures methods against exact references.",
                              0,
                              0,
                              0};
    argp_err_exit_status = 2;
    argp_parse(&argp, argc, argv, 0, 0, &o);
    return o.list ? list() : run(&o.atlas);
}
