/* pel-atlas: lists its cases, and writes the figures of one as CSV. */
#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cases.h"

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

#define NAME(name) #name
#define FUNCTION(name) atlas_##name
static const char *const names[] = {ATLAS_CASES(NAME)};
static void (*const functions[])(struct atlas *a) = {ATLAS_CASES(FUNCTION)};
enum { CASES = sizeof names / sizeof *names };

static const char *name_of(int i)
{
    static char name[40];
    snprintf(name, sizeof name, "%s", names[i]);
    for (char *c = name; *c; c++)
        if (*c == '_')
            *c = '-';
    return name;
}

static int list(void)
{
    for (int i = 0; i < CASES; i++)
        puts(name_of(i));
    return 0;
}

/* A scene script, moved by whole pixels to a canvas of its own. */
static void print_wrong(const struct atlas *a)
{
    const struct pel_point *v = a->wrong.v;
    const int32_t left = a->wrong.bounds.x0, top = a->wrong.bounds.y0;
    if (a->wrong.size == 0) {
        fprintf(stderr, "pel-atlas: %s draws no triangle of %s wrong\n",
                a->smallest, a->name);
        return;
    }
    printf("# The smallest triangle of %s that is drawn wrong by %s,\n"
           "# %d %d px from here; its first wrong pixel is %d %d.\n"
           "# pel explain --all tells why Pel paints that one or does not.\n",
           a->name, a->smallest, (int)left, (int)top, (int)(a->wrong.x - left),
           (int)(a->wrong.y - top));
    printf("canvas %d %d xrgb8888\nclear #000000\npaint flat #ffffff\ntriangle",
           (int)(a->wrong.bounds.x1 - left), (int)(a->wrong.bounds.y1 - top));
    for (int i = 0; i < 3; i++)
        printf(" %.8f %.8f", v[i].x / 256.0 - left, v[i].y / 256.0 - top);
    printf("\n");
}

static int run(struct atlas *a)
{
    for (int i = 0; i < CASES; i++) {
        if (!a->name || strcmp(name_of(i), a->name) != 0)
            continue;
        if (!a->smallest)
            puts("case,method,x,y,metric,value,low,high,unit,command");
        functions[i](a);
        if (a->smallest && !a->judged) {
            fprintf(stderr,
                    "pel-atlas: %s draws no triangle in %s; damage, thinness, "
                    "overflow and map-sliver have triangles, and name the "
                    "methods in the second column\n",
                    a->smallest, a->name);
            return 2;
        }
        if (a->smallest)
            print_wrong(a);
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
