#include "sim/cli/arguments.h"

#include <argp.h>
#include <assert.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/color.h"
#include "sim/cli/child.h"
#include "sim/cli/commands.h"
#include "sim/cli/message.h"
#include "sim/cli/number.h"
#include "sim/image/format_names.h"

enum { FIRST_KEY = 0x100 };

static const struct option_row limit_options[] = {
    {"limit", "SECONDS,MEGABYTES",
     "that reading a file through a library may take: a mesh, or a picture "
     "other than .ppm (default: 60,2048)",
     OPTION_INTEGER, .n = 2, .separator = ',', .low = 1, .high = 1e6,
     .expected = "SECONDS,MEGABYTES such as 60,2048"},
    {.help = NULL},
};

/* All rows of a command, the last for argp's end. */
struct rows {
    char **argv, **arguments;
    struct argp_option argp[OPTIONS_MAX];
    const struct option_row *option[OPTIONS_MAX];
    void *input[OPTIONS_MAX];
    struct options_given *given[OPTIONS_MAX];
    int count, group;
};

bool option_refuse(const char *option, const char *text, const char *expected)
{
    return message_error("--%s is '%s': expected %s", option, text, expected);
}

/* strtod also takes blanks before a number, hexadecimal ones, and words. */
bool option_numbers(const char *text, const struct option_row *o, double *value)
{
    for (int i = 0; i < o->n; i++) {
        char *end;
        const size_t length = strspn(text, "+-.0123456789eE");
        value[i] = strtod(text, &end);
        if (end == text || end > text + length ||
            !(value[i] >= o->low && value[i] <= o->high) ||
            *end != (i < o->n - 1 ? o->separator : '\0'))
            return false;
        text = end + 1;
    }
    return true;
}

int choice_find(const char *names, const char *name)
{
    const size_t length = strlen(name);
    for (int i = 0; *names; i++) {
        const size_t n = strcspn(names, "|");
        if (n == length && memcmp(names, name, n) == 0)
            return i;
        names += n + (names[n] == '|');
    }
    return -1;
}

static bool parse_integers(const struct option_row *o, const char *text,
                           int *value)
{
    enum { MOST = 2 };
    double number[MOST];
    const char digits[] = {'-', '0', '1', '2', '3',          '4', '5',
                           '6', '7', '8', '9', o->separator, '\0'};
    assert(o->n <= MOST);
    if (text[strspn(text, digits)] || !option_numbers(text, o, number))
        return option_refuse(o->name, text, o->expected);
    for (int i = 0; i < o->n; i++)
        value[i] = (int)number[i];
    return true;
}

static bool parse_integer(const struct option_row *o, const char *text,
                          int *value)
{
    int64_t v = 0;
    const bool good = number_integer(text, (int64_t)o->low, (int64_t)o->high,
                                     &v) == NUMBER_OK;
    *value = (int)v;
    return good || message_error("--%s is '%s': expected a whole number from "
                                 "%.0f to %.0f",
                                 o->name, text, o->low, o->high);
}

static bool parse_choice(const struct option_row *o, const char *text,
                         void *value)
{
    const int choice = choice_find(o->expected, text);
    if (choice < 0)
        return option_refuse(o->name, text, o->expected);
    if (o->n == sizeof(bool))
        *(bool *)value = choice == 1;
    else
        *(int *)value = choice;
    return true;
}

static bool parse_color(const struct option_row *o, const char *text,
                        pel_color *color)
{
    char full[10] = "#"; /* which may be missing */
    strncat(full, text + (*text == '#'), 8);
    return (number_color(full, color) == 7 && !full[7]) ||
           option_refuse(o->name, text, "#rrggbb, such as #ffffff");
}

static bool parse_value(const struct option_row *o, const char *text,
                        void *input)
{
    void *value = (char *)input + o->offset;
    switch (o->kind) {
    case OPTION_FLAG:
        *(bool *)value = true;
        return true;
    case OPTION_TEXT:
        *(const char **)value = text;
        return true;
    case OPTION_INTEGER:
        return o->n ? parse_integers(o, text, value)
                    : parse_integer(o, text, value);
    case OPTION_NUMBERS:
        return option_numbers(text, o, value) ||
               option_refuse(o->name, text, o->expected);
    case OPTION_CHOICE:
        return parse_choice(o, text, value);
    case OPTION_COLOR:
        return parse_color(o, text, value);
    case OPTION_FORMAT:
        *(const struct pel_format **)value = format_find(text);
        return format_find(text) || option_refuse(o->name, text, format_list());
    default:
        return o->parse(o->name, text, input);
    }
}

bool options_has(const struct options_given *given, const char *name)
{
    for (int i = 0; i < given->count; i++)
        if (strcmp(given->names[i], name) == 0)
            return true;
    return false;
}

static error_t parse_option(struct rows *rows, int i, const char *text)
{
    const struct option_row *o = rows->option[i];
    struct options_given *given = rows->given[i];
    if (given && !options_has(given, o->name))
        given->names[given->count++] = o->name;
    if (o->flag)
        *((bool *)rows->input[i] + o->flag) = true;
    return parse_value(o, text, rows->input[i]) ? 0 : EINVAL;
}

/* Takes the real arguments first; see arguments_parse. */
static error_t parse(int key, char *text, struct argp_state *state)
{
    struct rows *rows = state->input;
    if (key == ARGP_KEY_INIT)
        state->argv = rows->argv;
    if (key == ARGP_KEY_ARG)
        return ARGP_ERR_UNKNOWN; /* comes again as ARGP_KEY_ARGS */
    if (key == ARGP_KEY_ARGS)
        rows->arguments = state->argv + state->next;
    for (int i = 0; i < rows->count; i++)
        if (rows->option[i]->kind != OPTION_HEADING && rows->argp[i].key == key)
            return parse_option(rows, i, text);
    return key == ARGP_KEY_INIT || key == ARGP_KEY_ARGS ? 0 : ARGP_ERR_UNKNOWN;
}

static void add_rows(struct rows *rows, const struct option_row *o, void *input,
                     struct options_given *given)
{
    for (; o->help; o++) {
        const int i = rows->count++;
        assert(i < OPTIONS_MAX - 1);
        rows->group += o->kind == OPTION_HEADING;
        rows->option[i] = o;
        rows->input[i] = input;
        rows->given[i] = given;
        rows->argp[i] = (struct argp_option){
            .name = o->name,
            .key = !o->name    ? 0
                   : o->letter ? o->letter
                               : FIRST_KEY + i,
            .arg = o->argument,
            .doc = o->help,
            .group = o == limit_options ? -1 : rows->group};
    }
}

/* Messages of getopt begin with argv[0], which is to be "pel"; help shows the
 * program's invocation name, "pel NAME", where argv is not that of the call. */
char **arguments_parse(const struct command_line *line, int argc, char **argv)
{
    static char program[] = "pel";
    struct rows rows = {.argv = argv, .arguments = argv + argc};
    const struct argp argp = {.options = rows.argp,
                              .parser = parse,
                              .args_doc = line->arguments,
                              .doc = line->about};
    char *unused[] = {program, NULL};
    for (int i = 0; line->tables[i].options; i++)
        add_rows(&rows, line->tables[i].options, line->tables[i].input,
                 line->tables[i].given);
    add_rows(&rows, limit_options, &child_limits, NULL);
    program_invocation_short_name = argv[0];
    argv[0] = program;
    argp_err_exit_status = STATUS_ERROR;
    if (argp_parse(&argp, argc, unused, 0, NULL, &rows) != 0)
        exit(STATUS_ERROR);
    const int count = (int)(argv + argc - rows.arguments);
    if (count < line->least || count > line->most) {
        message_error("%d argument%s: expected %s", count,
                      count == 1 ? "" : "s", line->arguments);
        exit(STATUS_ERROR);
    }
    return rows.arguments;
}
