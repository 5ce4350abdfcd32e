/* Times Pel, memset and the installed peers on the workloads. */
#define _GNU_SOURCE
#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

enum { WORKLOADS_MAX = 100 };

struct options {
    struct measure_options measure;
    const char *csv, *only, *skip, *name;
    bool append, list;
};

static const struct argp_option option_table[] = {
    {"repeats", 'r', "N", 0, "samples of each method (21; 3 to 101)", 0},
    {"csv", 'c', "FILE", 0, "write the figures to FILE", 0},
    {"only", 'o', "TEXT", 0, "only workloads whose name contains TEXT", 0},
    {"skip", 'k', "TEXT", 0, "no workloads whose name contains TEXT", 0},
    {"append", 'a', 0, 0, "add the figures to the end of FILE", 0},
    {"no-coverage", 'n', 0, 0, "do not compare pixels with Pel's", 0},
    {"list", 'l', 0, 0, "print the names of the workloads", 0},
    {0},
};

static error_t parse(int key, char *arg, struct argp_state *state)
{
    struct options *o = state->input;
    switch (key) {
    case 'r':
        o->measure.repeats = atoi(arg);
        if (o->measure.repeats < 3 || o->measure.repeats > REPEATS_MAX)
            argp_error(state, "--repeats is 3 to %d, not %s", REPEATS_MAX, arg);
        return 0;
    case 'c':
        o->csv = arg;
        return 0;
    case 'o':
        o->only = arg;
        return 0;
    case 'k':
        o->skip = arg;
        return 0;
    case 'a':
        o->append = true;
        return 0;
    case 'n':
        o->measure.no_coverage = true;
        return 0;
    case 'l':
        o->list = true;
        return 0;
    case ARGP_KEY_ARG:
        if (o->name)
            argp_usage(state);
        o->name = arg;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static bool is_wanted(const struct options *o, const char *name)
{
    return (!o->name || strcmp(name, o->name) == 0) &&
           (!o->only || strstr(name, o->only)) &&
           !(o->skip && strstr(name, o->skip));
}

static int measure_all(const struct options *o, struct workload *w,
                       struct measurement *m)
{
    int n = 0;
    for (const struct workload *from = workloads; from->name; from++) {
        if (!is_wanted(o, from->name))
            continue;
        w[n] = *from;
        if (n == WORKLOADS_MAX || !workload_open(&w[n]))
            method_fail("out of memory", "free some and start again");
        measure(&m[n], &w[n], &o->measure);
        report_table(stdout, &m[n]);
        fflush(stdout);
        workload_close(&w[n]);
        n++;
    }
    return n;
}

static void write_csv(const struct options *o, const struct measurement *m,
                      int n)
{
    FILE *out = fopen(o->csv, o->append ? "a" : "w");
    if (!out)
        method_fail(o->csv, "name a file that can be written");
    if (!o->append)
        report_csv_header(out);
    for (int i = 0; i < n; i++)
        report_csv(out, &m[i]);
    if (ferror(out) | fclose(out))
        method_fail(o->csv, "name a file on a disk with free space");
}

static void print_names(void)
{
    for (const struct workload *w = workloads; w->name; w++)
        puts(w->name);
}

int main(int argc, char **argv)
{
    static struct workload workload[WORKLOADS_MAX];
    static struct measurement measurement[WORKLOADS_MAX];
    struct options o = {.measure = {21, false}};
    const struct argp argp = {
        option_table,
        parse,
        "[NAME]",
        "Times Pel, memset and the installed peers on all "
        "workloads, or on the one of that name.",
        0,
        0,
        0};
    argp_err_exit_status = 2;
    argp_parse(&argp, argc, argv, 0, 0, &o);
    if (o.list) {
        print_names();
        return 0;
    }
    if (!method_is_pel(methods[0]))
        method_fail("there is no build of Pel", "install gcc or clang");
    timing_pin();
    fputs(methods_absent, stdout);
    int n = measure_all(&o, workload, measurement);
    if (n == 0)
        method_fail("no such workload", "see --list");
    report_verdict(stdout, measurement, n);
    if (o.csv)
        write_csv(&o, measurement, n);
    return 0;
}
