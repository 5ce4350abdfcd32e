#include "sim/cli/arguments.h"

#include <argp.h>
#include <assert.h>
#include <errno.h>
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
     "that reading a file may take (default: 60,2048)", OPTION_INTEGER, .n = 2,
     .separator = ',', .low = 1, .high = 1e6,
     .expected = "SECONDS,MEGABYTES such as 60,2048"},
    {.help = NULL},
};

/* All rows of a command, the last for argp's end. */
struct rows {
    char **argv, **arguments;
    struct argp_option argp[OPTIONS_MAX];
    struct row {
        const struct option_row *option;
        const struct option_table *table;
    } row[OPTIONS_MAX];
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

/* One, or as many as o->n says. */
static bool parse_integers(const struct option_row *o, const char *text,
                           int *value)
{
    const char *next = text;
    bool good = true;
    for (int i = 0; good && (i == 0 || i < o->n); i++) {
        char *end;
        const long v = strtol(next, &end, 10);
        good = *next >= '0' && *next <= '9' && v >= (long)o->low &&
               v <= (long)o->high &&
               *end == (i < o->n - 1 ? o->separator : '\0');
        value[i] = (int)v;
        next = end + 1;
    }
    if (good || o->expected)
        return good || option_refuse(o->name, text, o->expected);
    return message_error("--%s is '%s': expected a whole number from %.0f to "
                         "%.0f",
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
        return parse_integers(o, text, value);
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

static error_t parse_option(const struct row *row, const char *text)
{
    const struct option_row *o = row->option;
    struct options_given *given = row->table->given;
    if (given && !options_has(given, o->name))
        given->names[given->count++] = o->name;
    if (o->flag)
        *((bool *)row->table->input + o->flag) = true;
    return parse_value(o, text, row->table->input) ? 0 : EINVAL;
}

/* Takes the real arguments first; see arguments_parse. */
static error_t parse(int key, char *text, struct argp_state *state)
{
    struct rows *rows = state->input;
    if (key == ARGP_KEY_INIT)
        state->argv = rows->argv;
    if (key == ARGP_KEY_ARGS)
        rows->arguments = state->argv + state->next;
    if (key == ARGP_KEY_INIT || key == ARGP_KEY_ARGS)
        return 0;
    for (int i = 0; i < rows->count; i++)
        if (rows->argp[i].name && rows->argp[i].key == key)
            return parse_option(&rows->row[i], text);
    return ARGP_ERR_UNKNOWN; /* also ARGP_KEY_ARG: comes as ARGP_KEY_ARGS */
}

static void add_rows(struct rows *rows, const struct option_table *table)
{
    for (const struct option_row *o = table->options; o->help; o++) {
        const int i = rows->count++;
        assert(i < OPTIONS_MAX - 1);
        rows->group += o->kind == OPTION_HEADING;
        rows->row[i] = (struct row){o, table};
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

static bool is_plain(const char *text)
{
    while (*text >= ' ' && *text < 127)
        text++;
    return !*text;
}

static bool is_known(const struct rows *rows, const char *argument)
{
    const size_t n = strcspn(argument + 2, "=");
    for (int i = 0; i < rows->count; i++)
        if (rows->argp[i].name &&
            strncmp(rows->argp[i].name, argument + 2, n) == 0)
            return true;
    return false;
}

/* getopt shows an option that it does not know as it is: one that a terminal
 * might obey does not come so far. */
static void check_unknown(const struct rows *rows)
{
    for (char **at = rows->argv + 1; *at && strcmp(*at, "--") != 0; at++) {
        const char letter[2] = {(*at)[0] ? (*at)[1] : '\0'};
        if ((*at)[0] != '-' || is_plain(letter[0] == '-' ? *at : letter) ||
            (letter[0] == '-' && is_known(rows, *at)))
            continue;
        message_error("unknown option '%s': --help lists those that there are",
                      *at);
        exit(STATUS_ERROR);
    }
}

/* Messages of getopt begin with argv[0], which is to be "pel"; help shows the
 * program's invocation name, "pel NAME", where argv is not that of the call. */
char **arguments_parse(const struct command_line *line, int argc, char **argv)
{
    static char program[] = "pel";
    struct rows rows = {.argv = argv, .arguments = argv + argc};
    const struct option_table limits = {limit_options, &child_limits, NULL};
    const struct argp argp = {.options = rows.argp,
                              .parser = parse,
                              .args_doc = line->arguments,
                              .doc = line->about};
    char *unused[] = {program, NULL};
    for (int i = 0; line->tables[i].options; i++)
        add_rows(&rows, &line->tables[i]);
    add_rows(&rows, &limits);
    check_unknown(&rows);
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
